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

/// A primitive's box clipped to the node that refers to it.
struct PrimRef {
    Aabb box;              ///< of the part inside the node
    std::uint32_t id = 0;  ///< of the primitive
    float weight = 1.0F;   ///< how many primitives it stands for in costs; >= 1
};

static_assert(sizeof(PrimRef) == 32);

/// A plane to split a node at, where primitives in the plane go, and what the split costs.
struct SplitCandidate {
    SplitPlane plane;                            ///< strictly inside the node
    PlanarSide planar_side = PlanarSide::below;  ///< where primitives in the plane go
    double cost = 0.0;                           ///< SahCostModel::split_cost() of it
};

/// The sum of the weights; exact, so that it does not depend on their order (see SampleWeighting).
[[nodiscard]] COPPICE_EXPORT double weight_of(std::span<const PrimRef> prim_refs) noexcept;

/// A node about to be split: its box (never without area) and its PrimRefs (never none).
struct SplitQuery {
    std::span<const PrimRef> prim_refs;  ///< at least one
    Aabb box;                            ///< of the node; never without area
    const SahCostModel& cost;            ///< by which splits are compared
    double acceptable_cost;  ///< a rule that can choose looks further than its first axis until it
                             ///< finds a split that costs less
    Isa isa = Isa::scalar;   ///< that the processor has; the split does not depend on it
};

/// Finds where to split a node. Stateless; called from several threads at once.
class SplitFinder {
public:
    SplitFinder() = default;
    SplitFinder(const SplitFinder&) = delete;
    SplitFinder& operator=(const SplitFinder&) = delete;
    virtual ~SplitFinder() = default;

    /// A plane strictly inside the box, or nothing if the rule has none to offer.
    [[nodiscard]] virtual std::optional<SplitCandidate> find(const SplitQuery& query) const = 0;

    /// True if find() gives the cheapest split at any end of any PrimRef on any axis, of equal ones
    /// the first by axis, then by position. Whole trees are then built from events sorted once,
    /// which gives the same tree sooner, and find() is asked about small nodes only, if at all.
    [[nodiscard]] virtual bool finds_cheapest_end() const noexcept { return false; }

    /// True if a build that splits as long as it pays may cut the boxes of primitives in place of
    /// the primitives where a node has few: faster, and a little worse.
    [[nodiscard]] virtual bool allows_loose_small_nodes() const noexcept { return false; }
};

/// A split rule under its name, with one line on what it does.
struct SplitFinderEntry {
    std::string_view name;      ///< how options call it
    std::string_view summary;   ///< what it does, in one line
    const SplitFinder& finder;  ///< lives as long as the program
};

/// All split rules; the first is the default.
[[nodiscard]] COPPICE_EXPORT std::span<const SplitFinderEntry> split_finder_registry();

/// The rule of that name. Throws Error(invalid_argument) naming those that exist.
[[nodiscard]] COPPICE_EXPORT const SplitFinder& find_split_finder(std::string_view name);

/// The rule that the options ask for: their own, or that of the name. Throws like
/// find_split_finder().
[[nodiscard]] COPPICE_EXPORT const SplitFinder& split_finder_of(const SplitOptions& options);

}  // namespace coppice::inline v0
