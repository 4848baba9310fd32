#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "lab/contestant.h"
#include "lab/ray_figures.h"
#include "lab/ray_maker.h"
#include "lab/traced_tree.h"

#include <span>
#include <vector>

namespace coppice::lab {

/// The rays of a scene, made once, for all its trees. The mesh must outlive them.
class SceneRays {
public:
    /// Makes the rays of these kinds, from hits found through a tree by reference_method() that is
    /// built for that and freed; its hits are what those of all trees are compared with.
    /// Throws like RayMaker and build_wide_bvh().
    SceneRays(TriangleMeshView mesh, const RayOptions& options, std::span<const RayKind> kinds,
              int threads, const BuildControl& control = {});

    /// Whose hits the others are compared with: a name in method_registry().
    [[nodiscard]] static std::string_view reference_method() noexcept { return "fast"; }

    /// Traces all rays and measures: a counting pass, which warms up, then timed ones, of which the
    /// median is taken. Kinds that the camera sees no surface for are left out.
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

    std::vector<RaySet> sets_;
    int threads_;
};

}  // namespace coppice::lab
