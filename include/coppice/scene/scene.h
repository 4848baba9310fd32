#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/build_report.h"
#include "coppice/builders/bvh8_options.h"
#include "coppice/export.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/query/mesh_search.h"
#include "coppice/query/signed_distance.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/tree/bvh8.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace coppice::inline v0 {

/// A mesh together with the 8-wide tree to trace and search it: all that most programs need.
/// Queries are reentrant.
class COPPICE_EXPORT Scene {
public:
    /// Takes over the mesh and builds its tree. Throws Error like build_bvh8().
    explicit Scene(TriangleMesh mesh, const Bvh8Options& options = {},
                   const BuildControl& control = {});

    /// The closest hit, or nothing.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept;

    /// True if anything lies on the ray.
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;

    /// The first `hits.size()` hits that come after `*after`; see Bvh8Tracer, also for the three
    /// below.
    [[nodiscard]] std::size_t intersect_all(const Ray& ray, std::span<Hit> hits,
                                            const Hit* after = nullptr) const noexcept {
        return tracer_.intersect_all(ray, hits, after);
    }

    /// The number of triangles that the ray hits.
    [[nodiscard]] std::size_t count_hits(const Ray& ray) const noexcept {
        return tracer_.count_hits(ray);
    }

    /// The closest hit of each ray, one that is not is_hit() where there is none, on at most
    /// `threads` threads (0 = all).
    void intersect(std::span<const Ray> rays, std::span<Hit> hits, int threads = 0) const {
        tracer_.intersect(rays, hits, threads);
    }

    /// 1 for each ray on which anything lies, else 0.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> is_occluded,
                  int threads = 0) const {
        tracer_.occluded(rays, is_occluded, threads);
    }

    /// The first hits of each ray, as many of each as there is room for; see Bvh8Tracer.
    void intersect_all(std::span<const Ray> rays, std::span<Hit> hits,
                       std::span<std::size_t> counts, int threads = 0) const {
        tracer_.intersect_all(rays, hits, counts, threads);
    }

    /// The number of triangles that each ray hits.
    void count_hits(std::span<const Ray> rays, std::span<std::size_t> counts,
                    int threads = 0) const {
        tracer_.count_hits(rays, counts, threads);
    }

    /// The triangle nearest to a point, if one is within `max_distance`; see MeshSearch, also for
    /// the three below.
    [[nodiscard]] SurfaceNeighbor nearest(
        Vec3f point, float max_distance = MeshSearch::anywhere) const noexcept {
        return search_.nearest(point, max_distance);
    }

    /// The up to found.size() nearest triangles, in order. Returns how many there are.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<SurfaceNeighbor> found,
                                        float max_distance = MeshSearch::anywhere) const noexcept {
        return search_.nearest_k(point, found, max_distance);
    }

    /// Calls `visit` with all triangles within a distance, in no particular order.
    void for_each_within(Vec3f center, float radius,
                         Visitor<SurfaceNeighbor> visit) const noexcept {
        search_.for_each_within(center, radius, visit);
    }

    /// Calls `visit` with the ids of all triangles that overlap a box, in no particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept {
        search_.for_each_overlapping(box, visit);
    }

    /// Searches for many points at once.
    [[nodiscard]] const MeshSearch& search() const noexcept { return search_; }

    /// What tells the distance to the surface, negative inside. It does not need the scene later.
    /// Throws Error(unsupported) if the mesh is not closed.
    [[nodiscard]] SignedDistance make_signed_distance() const;

    /// The mesh, as it was given.
    [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }

    /// The tree over its triangles.
    [[nodiscard]] const Bvh8& tree() const noexcept { return tracer_.tree(); }

    /// How the tree was built and what it measures.
    [[nodiscard]] const BuildReport& build_report() const noexcept { return report_; }

private:
    TriangleMesh mesh_;
    BuildReport report_;
    Bvh8Tracer tracer_;
    MeshSearch search_;
};

}  // namespace coppice::inline v0
