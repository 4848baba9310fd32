#pragma once

#include "coppice/geom/ray.h"
#include "coppice/trace/traversal_counts.h"

#include "scenes/ray_sets.h"
#include "tracers/contestant.h"
#include "tracers/traced_tree.h"

#include <span>

namespace coppice::lab {

// All of these trace in parallel. A miss has an infinite t; of shadow rays only whether they hit
// anything is known: t is 0 then. All spans have one item a ray.

/// Traces rays of one kind.
void trace_rays(const TracedTree& tree, RayKind kind, std::span<const Ray> rays,
                std::span<Hit> hits);

/// The same through a peer's structure.
void trace_rays(const Contestant& contestant, RayKind kind, std::span<const Ray> rays,
                std::span<Hit> hits);

/// The same, counting what each ray visits: slower.
void trace_counting(const TracedTree& tree, RayKind kind, std::span<const Ray> rays,
                    std::span<Hit> hits, std::span<TraversalCounts> counts);

}  // namespace coppice::lab
