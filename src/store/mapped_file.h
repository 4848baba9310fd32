#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace coppice::inline v0 {

/// A regular file's bytes in memory, read from the disk as they are needed; aligned to a page. They
/// stay what they are if the file is replaced or removed; the file must not be cut short.
class MappedFile {
public:
    /// Throws Error if there is no such file, or it is empty or not regular, or it cannot be
    /// mapped.
    explicit MappedFile(const std::filesystem::path& file);

    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    MappedFile(MappedFile&&) = delete;
    MappedFile& operator=(MappedFile&&) = delete;
    ~MappedFile();

    [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

private:
    std::span<const std::byte> bytes_;
};

}  // namespace coppice::inline v0
