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

/// A mesh and the 8-wide tree for tracing and searching it: all that most programs need. Queries
/// are reentrant.
class COPPICE_EXPORT Scene {
public:
    /// Takes the mesh and builds its tree. Throws Error as build_bvh8() does.
    explicit Scene(TriangleMesh mesh, const Bvh8Options& options = {},
                   const BuildControl& control = {});

    /// The closest hit of a ray, or nothing.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept;

    /// True if the ray hits any triangle.
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;

    /// Writes the first hits after `*after` to `hits`; see Bvh8Tracer::intersect_all().
    [[nodiscard]] std::size_t intersect_all(const Ray& ray, std::span<Hit> hits,
                                            const Hit* after = nullptr) const noexcept {
        return tracer_.intersect_all(ray, hits, after);
    }

    /// The number of triangles that the ray hits.
    [[nodiscard]] std::size_t count_hits(const Ray& ray) const noexcept {
        return tracer_.count_hits(ray);
    }

    /// Writes the closest hit of rays[i] to hits[i], on at most `threads` threads (0 = all hardware
    /// threads); without a hit, hits[i].is_hit() is false. Throws as Bvh8Tracer::intersect() does.
    void intersect(std::span<const Ray> rays, std::span<Hit> hits, int threads = 0) const {
        tracer_.intersect(rays, hits, threads);
    }

    /// Sets is_occluded[i] to 1 if rays[i] hits any triangle, otherwise to 0.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> is_occluded,
                  int threads = 0) const {
        tracer_.occluded(rays, is_occluded, threads);
    }

    /// Writes the first hits of each ray, as many per ray as there is room for; see
    /// Bvh8Tracer::intersect_all().
    void intersect_all(std::span<const Ray> rays, std::span<Hit> hits,
                       std::span<std::size_t> counts, int threads = 0) const {
        tracer_.intersect_all(rays, hits, counts, threads);
    }

    /// Writes the number of triangles that rays[i] hits to counts[i].
    void count_hits(std::span<const Ray> rays, std::span<std::size_t> counts,
                    int threads = 0) const {
        tracer_.count_hits(rays, counts, threads);
    }

    /// The triangle nearest to `point`; see MeshSearch::nearest(). If none is within
    /// `max_distance`, the result's is_found() is false.
    [[nodiscard]] SurfaceNeighbor nearest(
        Vec3f point, float max_distance = MeshSearch::anywhere) const noexcept {
        return search_.nearest(point, max_distance);
    }

    /// Writes the nearest triangles to the front of `found` in order, at most found.size() of them.
    /// Returns their number.
    [[nodiscard]] std::size_t nearest_k(Vec3f point, std::span<SurfaceNeighbor> found,
                                        float max_distance = MeshSearch::anywhere) const noexcept {
        return search_.nearest_k(point, found, max_distance);
    }

    /// Calls `visit` for every triangle within a distance, once each, in no particular order.
    void for_each_within(Vec3f center, float radius,
                         Visitor<SurfaceNeighbor> visit) const noexcept {
        search_.for_each_within(center, radius, visit);
    }

    /// Calls `visit` with the id of every triangle that overlaps a closed box, once each, in no
    /// particular order.
    void for_each_overlapping(const Aabb& box, Visitor<std::uint32_t> visit) const noexcept {
        search_.for_each_overlapping(box, visit);
    }

    /// The search structure, which also has batched queries.
    [[nodiscard]] const MeshSearch& search() const noexcept { return search_; }

    /// Prepares signed distances to the surface, negative inside. The result does not depend on the
    /// scene's lifetime. Throws Error(unsupported) if the mesh is not closed.
    [[nodiscard]] SignedDistance make_signed_distance() const;

    /// The mesh as it was passed.
    [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }

    /// The tree over the triangles.
    [[nodiscard]] const Bvh8& tree() const noexcept { return tracer_.tree(); }

    /// The report of the tree's build, with its statistics.
    [[nodiscard]] const BuildReport& build_report() const noexcept { return report_; }

private:
    TriangleMesh mesh_;
    BuildReport report_;
    Bvh8Tracer tracer_;
    MeshSearch search_;
};

}  // namespace coppice::inline v0
