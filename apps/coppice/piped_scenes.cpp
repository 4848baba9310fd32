#include "piped_scenes.h"

#include "coppice/base/error.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace coppice::app {

namespace {

constexpr const char* input_name = "/dev/stdin";

[[noreturn]] void fail(const std::string& scene, const char* what) {
    throw file_error(ErrorCode::io, scene, fmt::format("{}: {}", what, std::strerror(errno)));
}

/// The open file that a scene's name stands for: that of standard input, or of /dev/fd/N, as a
/// shell names what `<(command)` gives.
std::optional<int> descriptor_of(std::string_view scene) {
    constexpr std::string_view folder = "/dev/fd/";
    if (scene == input_name) return STDIN_FILENO;
    if (!scene.starts_with(folder)) return std::nullopt;
    scene.remove_prefix(folder.size());
    int number = 0;
    const char* const last = scene.data() + scene.size();
    const auto [end, error] = std::from_chars(scene.data(), last, number);
    const bool is_number = error == std::errc{} && end == last && number >= 0;
    return is_number ? std::optional(number) : std::nullopt;
}

bool is_file(int descriptor, const std::string& scene) {
    struct stat status {};

    if (fstat(descriptor, &status) != 0) fail(scene, "cannot read");
    return S_ISREG(status.st_mode);
}

/// A new file in the folder for temporary ones (TMPDIR) that has no name any more.
class NamelessFile {
public:
    explicit NamelessFile(const std::string& scene)
        : name_((std::filesystem::temp_directory_path() / "coppice-XXXXXX").string()) {
        descriptor_ = mkstemp(name_.data());
        if (descriptor_ < 0) fail(scene, "cannot make a temporary file");
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
void copy_all(int from, int to, const std::string& scene) {
    std::array<char, 1 << 16> buffer{};
    for (;;) {
        const ssize_t got = read(from, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(scene, "cannot read");
        if (got == 0) return;
        for (ssize_t done = 0; done < got;) {
            const ssize_t put =
                write(to, buffer.data() + done, static_cast<std::size_t>(got - done));
            if (put < 0 && errno != EINTR) fail(scene, "cannot write a temporary file");
            done += std::max<ssize_t>(put, 0);
        }
    }
}

}  // namespace

void take_piped_scenes(std::vector<std::string>& scenes) {
    std::replace(scenes.begin(), scenes.end(), std::string("-"), std::string(input_name));
    for (const std::string& scene : scenes) {
        const std::optional<int> descriptor = descriptor_of(scene);
        if (!descriptor || is_file(*descriptor, scene)) continue;
        if (isatty(*descriptor) == 1) {
            throw file_error(ErrorCode::io, scene,
                             "is a terminal, not a scene; pipe a file into it");
        }
        const NamelessFile spool(scene);
        copy_all(*descriptor, spool.descriptor(), scene);
        if (dup2(spool.descriptor(), *descriptor) < 0) fail(scene, "cannot read a temporary file");
    }
}

}  // namespace coppice::app
