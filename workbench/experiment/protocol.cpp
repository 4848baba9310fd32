// The three protocols of the experiment. They differ in when the sampled tree stops and in whether
// it grows on after the refill:
// - `fixed` keeps the thesis's limit, counted in *sampled* primitives. At rate r the tree stops
//   about log2(1/r) levels early, and its leaves hold about 1/r times as many primitives.
// - `scaled` lowers the limit by the rate, so that refilled leaves are about as full as those of
//   the full tree.
// - `grown` builds the leaves on with all their primitives. At rate 1 that is the full tree under
//   the same rule, which is what the other rates must be compared with.
// Source: [Tsiompikas2022] sec. 4.3 for `fixed`; the other two are this project's own.

#include "experiment/protocol.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"

#include <array>
#include <cmath>

namespace coppice::lab {

namespace {

KdOptions fixed_options(const KdOptions& base, double rate, std::uint64_t seed) {
    KdOptions options = base;
    options.sample.rate = rate;
    options.sample.seed = seed;
    options.leaf_refinement = LeafRefinement::none;
    return options;
}

KdOptions scaled_options(const KdOptions& base, double rate, std::uint64_t seed) {
    KdOptions options = fixed_options(base, rate, seed);
    const double limit = std::round(base.split.max_leaf * rate);
    options.split.max_leaf = limit < 1.0 ? 1 : static_cast<std::uint32_t>(limit);
    return options;
}

KdOptions grown_options(const KdOptions& base, double rate, std::uint64_t seed) {
    KdOptions options = scaled_options(base, rate, seed);
    options.leaf_refinement = LeafRefinement::kd;
    return options;
}

constexpr std::array<Protocol, 3> protocols{{
    {"fixed", "the thesis as written: leaves hold at most max-leaf sampled primitives",
     &fixed_options},
    {"scaled", "as fixed, with the leaf limit scaled by the rate: max(1, round(max-leaf * rate))",
     &scaled_options},
    {"grown", "as scaled, then every leaf is built on with all its primitives until no split pays",
     &grown_options},
}};

}  // namespace

std::span<const Protocol> protocol_registry() {
    return protocols;
}

const Protocol& find_protocol(std::string_view name) {
    return find_named(protocol_registry(), name, "protocol");
}

}  // namespace coppice::lab
