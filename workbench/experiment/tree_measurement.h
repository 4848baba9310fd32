#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/tree/kd_tree.h"

#include "experiment/builders.h"
#include "experiment/scene_rays.h"
#include "rows/results.h"

namespace coppice::lab {

/// What a tree is built over and traced with.
struct MeasuredScene {
    PrimitiveSetView primitives;
    TriangleMeshView mesh;  ///< what trees that are not k-d trees are built over, and what is hit
    const SceneRays* rays = nullptr;  ///< null: the tree is not traced
    BuildControl control{};           ///< of our builds; peers have none
};

/// Builds a tree, measures it, traces the rays, and frees it. The report of a peer has times and
/// bytes only; its statistics are 0 and its cost NaN. Throws like the builders.
[[nodiscard]] TreeFigures measure_tree(const Builder& builder, const BuildOptions& options,
                                       const MeasuredScene& scene);

/// The expected primitive tests of a random line through the tree's box in leaves that were empty
/// in the sample and hold primitives.
[[nodiscard]] double unsampled_tests(const KdTree& tree);

}  // namespace coppice::lab
