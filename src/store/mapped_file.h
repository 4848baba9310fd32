#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace coppice::inline v0 {

/// A regular file mapped into memory for reading, aligned to a page. Pages are read from disk as
/// they are accessed. The contents stay valid if the file is replaced or removed, but the file must
/// not be truncated or modified.
class MappedFile {
public:
    /// Maps a file. Throws Error if the file does not exist, is empty, is not a regular file, or
    /// cannot be mapped.
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
