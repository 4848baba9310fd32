#pragma once

#include "coppice/base/cpu.h"
#include "coppice/builders/kd_options.h"
#include "coppice/cost/sah_cost_model.h"
#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_node.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace coppice::inline v0 {

/// A builder's entry for a primitive in a node: its box clipped to the node, and its id.
struct PrimRef {
    Aabb box;              ///< box of the primitive's part inside the node
    std::uint32_t id = 0;  ///< id of the primitive
    float weight = 1.0F;   ///< number of primitives it counts as in costs; >= 1
};

static_assert(sizeof(PrimRef) == 32);

/// A split of a node: the plane, the side of primitives that lie in the plane, and the cost.
struct SplitCandidate {
    SplitPlane plane;                            ///< plane strictly inside the node
    PlanarSide planar_side = PlanarSide::below;  ///< side of primitives in the plane
    double cost = 0.0;                           ///< SahCostModel::split_cost() of the split
};

/// The sum of the PrimRefs' weights. Exact, so that it does not depend on their order (see
/// SampleWeighting).
[[nodiscard]] COPPICE_EXPORT double weight_of(std::span<const PrimRef> prim_refs) noexcept;

/// A node to be split, and how to compare splits.
struct SplitQuery {
    std::span<const PrimRef> prim_refs;  ///< the node's PrimRefs; at least one
    Aabb box;                            ///< the node's box; has an area
    const SahCostModel& cost;            ///< cost model to compare splits with
    double acceptable_cost;  ///< a rule that tries one axis after another continues until
                             ///< a split costs less than this
    Isa isa = Isa::scalar;   ///< instruction set to use; does not change the split
};

/// Interface of split rules: finds where to split a node. Stateless; called from several threads at
/// once.
class SplitFinder {
public:
    SplitFinder() = default;
    SplitFinder(const SplitFinder&) = delete;
    SplitFinder& operator=(const SplitFinder&) = delete;
    virtual ~SplitFinder() = default;

    /// Returns a split at a plane strictly inside the box, or nothing if the rule finds none.
    [[nodiscard]] virtual std::optional<SplitCandidate> find(const SplitQuery& query) const = 0;

    /// True if find() returns the cheapest split at any end of any PrimRef on any axis; of equal
    /// ones the first by axis, then by position. Builders then sort events once for the whole tree,
    /// which gives the same tree sooner, and call find() for small nodes only, if at all.
    [[nodiscard]] virtual bool finds_cheapest_end() const noexcept { return false; }

    /// True if builds that split as long as a split pays may, in small nodes, clip the boxes of
    /// primitives instead of the primitives: faster, with slightly worse trees.
    [[nodiscard]] virtual bool allows_loose_small_nodes() const noexcept { return false; }
};

/// A registered split rule.
struct SplitFinderEntry {
    std::string_view name;      ///< name in SplitOptions
    std::string_view summary;   ///< what it does, in one line
    const SplitFinder& finder;  ///< lives as long as the program
};

/// All split rules; the first is the default.
[[nodiscard]] COPPICE_EXPORT std::span<const SplitFinderEntry> split_finder_registry();

/// The split rule called `name`. Throws Error(invalid_argument) with a list of the valid names if
/// there is none.
[[nodiscard]] COPPICE_EXPORT const SplitFinder& find_split_finder(std::string_view name);

/// The split rule of the options: `custom_rule` if set, else the one called `rule`. Throws as
/// find_split_finder() does.
[[nodiscard]] COPPICE_EXPORT const SplitFinder& split_finder_of(const SplitOptions& options);

}  // namespace coppice::inline v0
