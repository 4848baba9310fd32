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

/// The size of a readable file in bytes. Throws Error if the file does not exist, is not a regular
/// file (a device or a pipe may never end), or is empty.
[[nodiscard]] std::uint64_t regular_file_bytes(const std::filesystem::path& file);

/// A file that is read once from start to end, as lines or as bytes, through a buffer. Gzipped
/// contents are unpacked. All functions throw Error naming the file if reading fails.
class InputFile {
public:
    /// Opens a file. Throws Error unless it is a regular file that contains more than white space.
    explicit InputFile(const std::filesystem::path& file);

    /// The file as the user named it.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// The size on disk. For a gzipped file it says little about the size of the contents.
    [[nodiscard]] std::uint64_t stored_bytes() const noexcept { return stored_bytes_; }

    /// Unpacked bytes read so far.
    [[nodiscard]] std::uint64_t offset() const noexcept { return dropped_bytes_ + begin_; }

    /// The 1-based number of the line that next_line() returned last; 0 before the first.
    [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }

    /// The next line without its line end (LF, CRLF or CR), or nothing at the end of the file. The
    /// view is valid until the next call of a member function.
    [[nodiscard]] std::optional<std::string_view> next_line();

    /// The next `count` bytes, fewer at the end of the file; count <= chunk_bytes. The view is
    /// valid until the next call of a member function.
    [[nodiscard]] std::string_view read(std::size_t count) {
        while (end_ - begin_ < count && !is_exhausted_) {
            fill();
        }
        const std::string_view bytes = unread().substr(0, count);
        begin_ += bytes.size();
        return bytes;
    }

    /// Skips `count` bytes, or to the end of the file. Returns the number of bytes skipped.
    std::uint64_t skip(std::uint64_t count);

    /// Reads to the end of the file. Returns the number of bytes in the remaining lines that are
    /// not blank.
    std::uint64_t count_trailing_text();

    static constexpr std::size_t chunk_bytes = std::size_t{1} << 20;
    /// The greatest length of a line, which limits the memory that a malicious file can make us
    /// allocate.
    static constexpr std::size_t max_line_bytes = std::size_t{1} << 28;

private:
    [[nodiscard]] std::string_view unread() const noexcept {
        return {buffer_.data() + begin_, end_ - begin_};
    }

    /// Reads another chunk, or records that the file has ended.
    void fill();

    std::string name_;
    std::uint64_t stored_bytes_ = 0;
    std::unique_ptr<gzFile_s, int (*)(gzFile)> file_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;  ///< start of the unread part of the buffer
    std::size_t end_ = 0;
    std::uint64_t dropped_bytes_ = 0;  ///< bytes read that are no longer in the buffer
    std::size_t line_number_ = 0;
    bool is_exhausted_ = false;
};

}  // namespace coppice::inline v0
