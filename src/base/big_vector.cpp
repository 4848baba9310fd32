#include "coppice/base/big_vector.h"

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace coppice {
namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t huge_page = std::size_t{2} << 20U;

}  // namespace

void* allocate_big(std::size_t byte_count) {
    // Two pages and more: a smaller array would waste up to a whole one.
    const std::size_t alignment = byte_count >= 2 * huge_page ? huge_page : cache_line;
    const std::size_t padded = (byte_count + alignment - 1) / alignment * alignment;
    if (padded < byte_count) throw std::bad_alloc();
    void* storage = std::aligned_alloc(alignment, padded);
    if (storage == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    if (alignment == huge_page) madvise(storage, padded, MADV_HUGEPAGE);  // a wish, not a need
#endif
    return storage;
}

void free_big(void* storage) noexcept {
    std::free(storage);
}

}  // namespace coppice
