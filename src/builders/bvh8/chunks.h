// The chunks of a range of PrimRefs that are processed in parallel; one chunk unless the range is
// large. They depend on its size alone, so that the tree does not depend on the number of threads.

#pragma once

#include "coppice/base/parallel.h"

#include <algorithm>
#include <cstddef>

namespace coppice::inline v0::bvh8 {

class Chunks {
public:
    explicit Chunks(std::size_t size) noexcept
        : size_(size), chunk_size_(are_worth_it(size) ? large : std::max<std::size_t>(size, 1)) {}

    /// True if a range of `size` PrimRefs has more than one chunk.
    [[nodiscard]] static bool are_worth_it(std::size_t size) noexcept { return size >= 4 * large; }

    [[nodiscard]] std::size_t count() const noexcept {
        return (size_ + chunk_size_ - 1) / chunk_size_;
    }

    /// Calls body(chunk, begin, end) for each chunk [begin, end) of [0, size).
    template <typename Body>
    void for_each(Body&& body) const {
        parallel_for_chunks(size_, chunk_size_, [&](std::size_t begin, std::size_t end) {
            body(begin / chunk_size_, begin, end);
        });
    }

private:
    static constexpr std::size_t large = 16384;

    std::size_t size_;
    std::size_t chunk_size_;
};

}  // namespace coppice::inline v0::bvh8
