#pragma once

#include "expect.h"

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace coppice::fuzz {

/// A folder in memory for the files that a fuzz target reads, removed when the program ends.
class ScratchFolder {
public:
    ScratchFolder() : path_("/dev/shm/coppice_fuzz_" + std::to_string(getpid())) {
        std::filesystem::create_directories(path_);
    }

    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    /// Writes a file of that name anew and returns its path.
    [[nodiscard]] std::filesystem::path write(const std::string& name,
                                              std::string_view contents) const {
        std::filesystem::path file = path_ / name;
        std::FILE* const stream = std::fopen(file.c_str(), "wb");
        expect(stream != nullptr, "a scratch file to be opened");
        const std::size_t written = std::fwrite(contents.data(), 1, contents.size(), stream);
        expect(std::fclose(stream) == 0 && written == contents.size(),
               "a scratch file to be written");
        return file;
    }

private:
    std::filesystem::path path_;
};

/// The folder of this process.
[[nodiscard]] inline const ScratchFolder& scratch_folder() {
    static const ScratchFolder folder;
    return folder;
}

/// The fuzzer's input as text.
[[nodiscard]] inline std::string_view text_of(std::span<const std::uint8_t> bytes) noexcept {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace coppice::fuzz
