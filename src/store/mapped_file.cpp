#include "store/mapped_file.h"

#include "coppice/base/error.h"

#include "io/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

namespace coppice::inline v0 {
namespace {

class Descriptor {
public:
    explicit Descriptor(int number) noexcept : number_(number) {}

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    ~Descriptor() {
        if (number_ >= 0) close(number_);
    }

    [[nodiscard]] int number() const noexcept { return number_; }

private:
    int number_;
};

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view what) {
    throw file_error(ErrorCode::io, file.string(),
                     fmt::format("cannot {}: {}", what, std::strerror(errno)));
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& file) {
    static_cast<void>(
        regular_file_bytes(file));  // called for its errors; the size of the open file counts
    const Descriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC));

    struct stat status {};

    if (opened.number() < 0 || fstat(opened.number(), &status) != 0) fail(file, "open");
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size == 0) throw file_error(ErrorCode::parse, file.string(), "empty file");
    void* const start =
        mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, opened.number(), 0);
    if (start == MAP_FAILED) fail(file, "map into memory");
    bytes_ = {static_cast<const std::byte*>(start), size};
}

MappedFile::~MappedFile() {
    munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

}  // namespace coppice::inline v0
