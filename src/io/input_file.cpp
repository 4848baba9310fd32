#include "io/input_file.h"

#include "coppice/base/error.h"

#include "io/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace coppice::inline v0 {

std::uint64_t regular_file_bytes(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code problem;
    const std::filesystem::file_status status = std::filesystem::status(file, problem);
    if (status.type() == std::filesystem::file_type::not_found) {
        throw file_error(ErrorCode::io, name, "no such file");
    }
    if (std::filesystem::is_directory(status)) {
        throw file_error(ErrorCode::io, name, "is a directory, not a file");
    }
    if (!problem && !std::filesystem::is_regular_file(status)) {
        throw file_error(ErrorCode::io, name, "not a regular file");
    }
    const std::uint64_t size = problem ? 0 : std::filesystem::file_size(file, problem);
    if (problem) {
        throw file_error(ErrorCode::io, name, "cannot open: " + problem.message());
    }
    if (size == 0) {
        throw file_error(ErrorCode::parse, name, "empty file");
    }
    return size;
}

InputFile::InputFile(const std::filesystem::path& file)
    : name_(file.string()),
      stored_bytes_(regular_file_bytes(file)),
      file_(gzopen(file.c_str(), "rb"), &gzclose_r) {
    if (!file_) {
        throw file_error(ErrorCode::io, name_,
                         fmt::format("cannot open: {}", std::strerror(errno)));
    }
    gzbuffer(file_.get(), chunk_bytes / 4);
    fill();
    // zlib passes data through unchanged if it is not gzipped.
    if (to_lower(file.extension().string()) == ".gz" && gzdirect(file_.get()) != 0) {
        throw file_error(ErrorCode::parse, name_, "not a gzip file");
    }
    if (end_ < chunk_bytes && is_blank(unread())) {
        throw file_error(ErrorCode::parse, name_, "empty file");
    }
}

void InputFile::fill() {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    dropped_bytes_ += begin_;
    end_ -= begin_;
    begin_ = 0;
    buffer_.resize(std::max(buffer_.size(), end_ + chunk_bytes));
    const int got = gzread(file_.get(), buffer_.data() + end_, chunk_bytes);
    // A truncated gzip stream yields the data it has; only gzerror() reports the truncation.
    int code = Z_OK;
    std::string_view problem = gzerror(file_.get(), &code);
    problem.remove_prefix(problem.starts_with(name_) ? name_.size() + 2 : 0);  // "name: "
    if (code == Z_ERRNO) {
        throw file_error(ErrorCode::io, name_,
                         fmt::format("cannot read: {}", std::strerror(errno)));
    }
    if (got < 0 || code == Z_BUF_ERROR) {
        throw file_error(ErrorCode::parse, name_, fmt::format("damaged gzip file: {}", problem));
    }
    end_ += static_cast<std::size_t>(got);
    is_exhausted_ = static_cast<std::size_t>(got) < chunk_bytes;
}

std::optional<std::string_view> InputFile::next_line() {
    const auto is_line_end = [](char c) { return c == '\n' || c == '\r'; };
    std::size_t length = 0;
    for (;;) {
        const std::string_view rest = unread();
        const auto* found = std::find_if(rest.begin() + length, rest.end(), is_line_end);
        length = static_cast<std::size_t>(found - rest.begin());
        // A CR at the end of the buffer may be the first half of a CRLF.
        if (is_exhausted_ || length + 1 < rest.size() || (length < rest.size() && *found == '\n')) {
            break;
        }
        if (length > max_line_bytes) {
            throw file_error(ErrorCode::limit, name_, line_number_ + 1,
                             fmt::format("line longer than {} bytes", max_line_bytes));
        }
        fill();
    }
    const std::string_view rest = unread();
    if (rest.empty()) {
        return std::nullopt;
    }
    const std::string_view line_end = rest.substr(length, 2);
    begin_ += length + (line_end == "\r\n" ? 2 : std::min<std::size_t>(line_end.size(), 1));
    ++line_number_;
    return rest.substr(0, length);
}

std::uint64_t InputFile::skip(std::uint64_t count) {
    std::uint64_t skipped = 0;
    while (skipped < count) {
        const auto step =
            static_cast<std::size_t>(std::min<std::uint64_t>(count - skipped, chunk_bytes));
        const std::size_t got = read(step).size();
        skipped += got;
        if (got < step) {
            break;
        }
    }
    return skipped;
}

std::uint64_t InputFile::count_trailing_text() {
    std::uint64_t count = 0;
    while (const std::optional<std::string_view> line = next_line()) {
        count += is_blank(*line) ? 0 : line->size();
    }
    return count;
}

}  // namespace coppice::inline v0
