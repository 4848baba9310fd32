#include "coppice/base/big_buffer.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace coppice::inline v0 {
namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t small_page = 4096;
constexpr std::size_t huge_page = std::size_t{2} << 20U;

// No address space is larger, and rounding up a smaller size does not overflow.
constexpr std::size_t most_bytes = SIZE_MAX / 4;

constexpr std::size_t round_up(std::size_t size, std::size_t unit) noexcept {
    return (size + unit - 1) / unit * unit;
}

}  // namespace

BigBuffer::BigBuffer(std::size_t byte_count) : byte_count_(byte_count) {
    if (byte_count > most_bytes) throw std::bad_alloc();
    // For smaller blocks, the unused rest of the last huge page would waste too much memory.
    const bool is_huge = byte_count >= 2 * huge_page;
    const std::size_t alignment = is_huge ? huge_page : cache_line;
    const std::size_t padded = round_up(std::max(byte_count, cache_line), alignment);
    bytes_.reset(static_cast<std::byte*>(std::aligned_alloc(alignment, padded)));
    if (!bytes_) throw std::bad_alloc();
#if defined(__linux__)
    if (is_huge) madvise(bytes_.get(), padded, MADV_HUGEPAGE);  // a hint: failure does not matter
#endif
}

void BigBuffer::shrink(std::size_t byte_count) {
    if (byte_count >= byte_count_) return;
#if defined(__linux__)
    if (byte_count_ >= 2 * huge_page) {  // smaller blocks may share their last page with others
        const std::size_t kept = round_up(byte_count, small_page);
        const std::size_t end = round_up(byte_count_, huge_page);
        madvise(bytes_.get() + kept, end - kept, MADV_DONTNEED);
    }
#endif
    byte_count_ = byte_count;
}

void BigBuffer::Free::operator()(std::byte* bytes) const noexcept {
    std::free(bytes);
}

}  // namespace coppice::inline v0
