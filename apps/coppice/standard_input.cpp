#include "standard_input.h"

#include "coppice/base/error.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace coppice::app {

namespace {

constexpr const char* input_name = "/dev/stdin";

[[noreturn]] void fail(const char* what) {
    throw file_error(ErrorCode::io, input_name, fmt::format("{}: {}", what, std::strerror(errno)));
}

bool is_file(int descriptor) {
    struct stat status {};

    if (fstat(descriptor, &status) != 0) fail("cannot read");
    return S_ISREG(status.st_mode);
}

/// A new file in the folder for temporary ones (TMPDIR) that has no name any more.
class NamelessFile {
public:
    NamelessFile() : name_((std::filesystem::temp_directory_path() / "coppice-XXXXXX").string()) {
        descriptor_ = mkstemp(name_.data());
        if (descriptor_ < 0) fail("cannot make a temporary file");
        unlink(name_.c_str());
    }

    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;

    ~NamelessFile() { close(descriptor_); }

    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

private:
    std::string name_;
    int descriptor_;
};

/// Copies what comes in; a piece that is not written whole is an error, as on a full disk.
void copy_input(int to) {
    std::array<char, 1 << 16> buffer{};
    for (;;) {
        const ssize_t got = read(STDIN_FILENO, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail("cannot read");
        if (got == 0) return;
        for (ssize_t done = 0; done < got;) {
            const ssize_t put =
                write(to, buffer.data() + done, static_cast<std::size_t>(got - done));
            if (put < 0 && errno != EINTR) fail("cannot write a temporary file");
            done += std::max<ssize_t>(put, 0);
        }
    }
}

}  // namespace

void take_standard_input(std::vector<std::string>& scenes) {
    std::replace(scenes.begin(), scenes.end(), std::string("-"), std::string(input_name));
    if (std::find(scenes.begin(), scenes.end(), input_name) == scenes.end()) return;
    if (is_file(STDIN_FILENO)) return;
    if (isatty(STDIN_FILENO) == 1) {
        throw file_error(ErrorCode::io, input_name, "is a terminal: no scene comes in");
    }
    const NamelessFile spool;
    copy_input(spool.descriptor());
    if (dup2(spool.descriptor(), STDIN_FILENO) < 0) fail("cannot read a temporary file");
}

}  // namespace coppice::app
