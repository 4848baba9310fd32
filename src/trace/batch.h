#pragma once

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include <fmt/format.h>

#include <cstddef>

namespace coppice::trace {

/// Calls `body(i)` for every ray of a batch, in parallel chunks if there is more than one thread
/// (0 = all). Throws Error(invalid_argument) unless there is one result a ray.
template <typename F>
void for_each_ray(std::size_t ray_count, std::size_t result_count, int threads, F&& body) {
    if (ray_count != result_count) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("{} rays, but room for {} results", ray_count, result_count));
    }
    if (threads < 0) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("threads {} is outside [0, 2^31)", threads));
    }
    const auto run = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            body(i);
        }
    };
    // Enough to make up for handing it over, few enough to share out evenly.
    constexpr std::size_t chunk_size = 1024;
    if (threads == 1 || ray_count <= chunk_size) return run(0, ray_count);
    run_with_threads(threads, [&] { parallel_for_chunks(ray_count, chunk_size, run); });
}

}  // namespace coppice::trace
