#pragma once

#include "coppice/base/memory_meter.h"
#include "coppice/build/build_options.h"
#include "coppice/build/split_finder.h"
#include "coppice/geom/primitive_set.h"

#include "build/subtree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace coppice {

/// How long split rules look for a plane.
enum class SplitSearch {
    first_offer,   ///< the first axis that offers a plane decides, as in the thesis
    until_it_pays  ///< on through all axes until a split costs less than the leaf
};

/// When a node is not split any further.
struct StopRule {
    std::uint32_t max_leaf;  ///< nodes of at most that weight are leaves; 0: only empty ones
    int bad_refines;         ///< as in SplitOptions; 1: no split that does not pay
    int max_depth;
    SplitSearch search;
};

/// Builds k-d (sub)trees top-down by one split rule: what building on the sample and growing the
/// leaves share. Subtrees above a fixed size are built in parallel; the result does not depend on
/// the number of threads.
class KdBuilder {
public:
    KdBuilder(PrimitiveSetView primitives, const BuildOptions& options, const StopRule& stop,
              MemoryMeter* meter = nullptr);

    /// The subtree of a node with these fragments, box and depth.
    [[nodiscard]] Subtree build(std::vector<Fragment> fragments, const Aabb& box, int depth) const;

private:
    struct Node {
        std::vector<Fragment> fragments;
        Aabb box;
        int depth;
        int bad_refines_so_far;
        MeteredBytes bytes;  // of the fragments
    };

    [[nodiscard]] std::optional<Split> find_split(Node& node) const;
    void build_into(Subtree& tree, std::uint32_t slot, Node node) const;

    PrimitiveSetView primitives_;
    const SplitFinder& finder_;
    SahCostModel cost_;
    Clipping clipping_;
    StopRule stop_;
    MemoryMeter* meter_;
};

}  // namespace coppice
