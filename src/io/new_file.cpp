#include "io/new_file.h"

#include "coppice/base/error.h"
#include "coppice/io/write_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace coppice::inline v0 {

namespace {

/// A name that no other NewFile on this machine uses at this time. Short, so that it is valid
/// wherever the final name is.
std::string temporary_name() {
    static std::atomic<unsigned> next_number{0};
    return fmt::format(".coppice-{}-{}.tmp", getpid(), next_number++);
}

}  // namespace

NewFile::NewFile(const std::filesystem::path& file) : file_(file), target_(write_target(file)) {
    do {
        temporary_ = target_.parent_path() / temporary_name();
        stream_ = std::fopen(temporary_.c_str(), "wbx");
    } while (stream_ == nullptr && errno == EEXIST);
    if (stream_ == nullptr) {
        fail(errno);
    }
}

NewFile::~NewFile() {
    if (stream_ != nullptr) {
        static_cast<void>(std::fclose(stream_));
    }
    if (!temporary_.empty()) {
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
    }
}

void NewFile::write(std::string_view bytes) {
    if (bytes.empty()) return;  // data() may be null, which fwrite() does not allow
    if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) < bytes.size()) {
        fail(errno);
    }
}

void NewFile::sync() {
    if (std::fflush(stream_) != 0 || fsync(fileno(stream_)) != 0) {
        fail(errno);
    }
}

void NewFile::close() {
    if (stream_ == nullptr) return;
    // Flushes the buffer. A full disk may be reported only here.
    std::FILE* const stream = stream_;
    stream_ = nullptr;
    if (std::fclose(stream) != 0) {
        fail(errno);
    }
}

void NewFile::commit() {
    close();
    std::error_code problem;
    std::filesystem::rename(temporary_, target_, problem);
    if (problem) {
        fail(problem.value());
    }
    temporary_.clear();
}

void NewFile::fail(int error_number) const {
    throw file_error(ErrorCode::io, file_.string(),
                     fmt::format("cannot write: {}", std::strerror(error_number)));
}

}  // namespace coppice::inline v0
