#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "rows/ray_figures.h"
#include "rows/results.h"
#include "scenes/ray_maker.h"
#include "tracers/contestant.h"
#include "tracers/traced_tree.h"

#include <optional>
#include <span>
#include <vector>

namespace coppice::lab {

/// The rays of a scene, made once for all its trees, and the reference tree. The mesh must outlive
/// them.
class SceneRays {
public:
    /// Builds a tree by reference_method and makes the rays of these kinds from its hits. The tree
    /// is kept: hits and times of all trees are compared with its own. Throws like RayMaker and
    /// build_bvh8().
    SceneRays(TriangleMeshView mesh, const RayOptions& options, std::span<const RayKind> kinds,
              int threads, const BuildControl& control = {});

    /// Traces all rays and measures: a counting pass, which warms up, then timed ones in turns with
    /// the reference, of which medians are taken; see remove_drift(). Kinds that the camera sees no
    /// surface for are left out.
    [[nodiscard]] std::vector<RayFigures> measure(const TracedTree& tree) const;

    /// The same through a peer's structure, whose steps cannot be counted.
    [[nodiscard]] std::vector<RayFigures> measure(const Contestant& contestant) const;

private:
    struct RaySet {
        RayKind kind;
        std::vector<Ray> rays;
        std::vector<Hit> expected;
    };

    template <typename Tracer>
    [[nodiscard]] RayFigures measure_set(const Tracer& tracer, const RaySet& set) const;

    std::optional<TracedTree> reference_;
    std::vector<RaySet> sets_;
    int threads_;
};

}  // namespace coppice::lab
