#include "builders/require_usable.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "builders/chunk_sizes.h"

#include <fmt/format.h>

#include <atomic>

namespace coppice::inline v0 {
namespace {

bool is_valid(PrimitiveSetView primitives, std::uint32_t first, std::uint32_t last) {
    try {
        primitives.require_valid(first, last);
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

void require_usable(PrimitiveSetView primitives) {
    std::atomic<bool> are_valid = true;
    std::atomic<std::uint32_t> first_bad = primitives.size();
    parallel_for_chunks(
        primitives.size(), primitives_per_task, [&](std::size_t begin, std::size_t end) {
            auto id = static_cast<std::uint32_t>(begin);
            if (!is_valid(primitives, id, static_cast<std::uint32_t>(end))) {
                are_valid = false;
                return;
            }
            while (id < end && primitives.bounds(id).is_finite()) {
                ++id;
            }
            std::uint32_t first = first_bad;
            while (id < end && id < first && !first_bad.compare_exchange_weak(first, id)) {
            }
        });
    if (!are_valid) primitives.require_valid(0, primitives.size());  // throws for the first one
    if (first_bad == primitives.size()) return;
    throw Error(ErrorCode::invalid_argument,
                fmt::format("primitive {} has a box that is not finite: fix or remove it",
                            first_bad.load()));
}

}  // namespace coppice::inline v0
