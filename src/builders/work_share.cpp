#include "builders/work_share.h"

#include <algorithm>
#include <cmath>

namespace coppice::inline v0 {
namespace {

// The work below a node of `count` PrimRefs, in passes over them: one for each level where nodes
// are large, plus 20 for the rest, which is in the cache. 20 is an average over the methods.
double work_below(std::size_t count) noexcept {
    constexpr double small_node = 4096.0;
    constexpr double small_passes = 20.0;
    const auto n = static_cast<double>(count);
    return n * (small_passes + std::max(0.0, std::log2(n / small_node)));
}

}  // namespace

WorkShare::Children WorkShare::divide(std::size_t count, std::size_t below,
                                      std::size_t above) const {
    if (!is_asked_for()) return {};
    const auto own = static_cast<double>(count);
    const double of_below = work_below(below);
    const double of_above = work_below(above);
    const double all = own + of_below + of_above;
    part(own / all).done();
    return {part(of_below / all), part(of_above / all)};
}

}  // namespace coppice::inline v0
