#pragma once

#include "coppice/base/big_buffer.h"
#include "coppice/base/memory_meter.h"

#include "builders/bvh8/prim_ref.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace coppice::inline v0::bvh8 {

/// The memory of a build: two buffers that PrimRefs are copied between in turns, and the ids of the
/// finished leaves. The finished tree is written into the same memory, because clearing new pages
/// took 7 % of the build time.
class DoubleBuffer {
public:
    DoubleBuffer(std::size_t reference_count, MemoryMeter& meter)
        : count_(reference_count),
          memory_(bytes_before_ids() + count_ * sizeof(std::uint32_t)),
          bytes_(&meter, memory_.byte_count()) {}

    [[nodiscard]] std::span<PrimRef> first() const noexcept {
        return memory_.view<PrimRef>(0, count_);
    }

    [[nodiscard]] std::span<PrimRef> second() const noexcept {
        return memory_.view<PrimRef>(count_ * sizeof(PrimRef), count_);
    }

    [[nodiscard]] std::span<std::uint32_t> ids() const noexcept {
        return memory_.view<std::uint32_t>(bytes_before_ids(), count_);
    }

    /// The size of both buffers in bytes, which is the offset of the ids.
    [[nodiscard]] std::size_t bytes_before_ids() const noexcept {
        return 2 * count_ * sizeof(PrimRef);
    }

    /// Moves the memory out. It stays counted as long as this object lives. The views stay valid as
    /// long as the returned buffer lives and is not shrunk.
    [[nodiscard]] BigBuffer release() noexcept { return std::move(memory_); }

private:
    std::size_t count_;
    BigBuffer memory_;
    MeteredBytes bytes_;
};

}  // namespace coppice::inline v0::bvh8
