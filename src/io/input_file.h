#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

/// The size of a file that is fit to be read. Throws Error: there is no such file, or it is no
/// regular file (a device or a pipe may never end), or it is empty.
[[nodiscard]] std::uint64_t regular_file_bytes(const std::filesystem::path& file);

/// A file read once from front to back, as lines or as bytes, through a buffer. Gzipped contents
/// are unpacked on the way. All functions throw Error naming the file if reading fails.
class InputFile {
public:
    /// Opens a regular file that holds more than white space; anything else is an Error.
    explicit InputFile(const std::filesystem::path& file);

    /// The file as the user named it.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Bytes on disk, which for a gzipped file says little about its contents.
    [[nodiscard]] std::uint64_t stored_bytes() const noexcept { return stored_bytes_; }

    /// Unpacked bytes read so far.
    [[nodiscard]] std::uint64_t offset() const noexcept { return dropped_bytes_ + begin_; }

    /// 1-based number of the line that next_line() gave last; 0 before the first.
    [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }

    /// The next line without its end (LF, CRLF or CR), or nothing at the end of the file. The view
    /// lives until the next call of a member function.
    [[nodiscard]] std::optional<std::string_view> next_line();

    /// The next `count` bytes, fewer at the end of the file; count <= chunk_bytes. The view lives
    /// until the next call of a member function.
    [[nodiscard]] std::string_view read(std::size_t count) {
        while (end_ - begin_ < count && !is_exhausted_) {
            fill();
        }
        const std::string_view bytes = unread().substr(0, count);
        begin_ += bytes.size();
        return bytes;
    }

    /// Moves on by `count` bytes, or to the end of the file; returns by how many.
    std::uint64_t skip(std::uint64_t count);

    /// Reads to the end of the file; returns the bytes of its remaining lines, but for blank ones.
    std::uint64_t count_trailing_text();

    static constexpr std::size_t chunk_bytes = std::size_t{1} << 20;
    /// No line is longer: a limit on what a hostile file can make us allocate.
    static constexpr std::size_t max_line_bytes = std::size_t{1} << 28;

private:
    [[nodiscard]] std::string_view unread() const noexcept {
        return {buffer_.data() + begin_, end_ - begin_};
    }

    /// Reads another chunk, or notes that there is no more.
    void fill();

    std::string name_;
    std::uint64_t stored_bytes_ = 0;
    std::unique_ptr<gzFile_s, int (*)(gzFile)> file_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;  ///< of the unread part of the buffer
    std::size_t end_ = 0;
    std::uint64_t dropped_bytes_ = 0;  ///< read, and no longer in the buffer
    std::size_t line_number_ = 0;
    bool is_exhausted_ = false;
};

}  // namespace coppice::inline v0
