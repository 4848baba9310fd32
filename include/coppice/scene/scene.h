#pragma once

#include "coppice/build/build_options.h"
#include "coppice/build/build_report.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/trace/wide_tracer.h"
#include "coppice/tree/wide_bvh.h"

#include <optional>

namespace coppice {

/// A mesh together with the wide tree to trace it: all that most programs need. Queries are
/// reentrant.
class Scene {
public:
    /// Takes over the mesh and builds its tree. Throws Error like build_wide_bvh().
    explicit Scene(TriangleMesh mesh, const BuildOptions& options = {});

    /// The closest hit, or nothing.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const noexcept;

    /// True if anything lies on the ray.
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;

    [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }

    [[nodiscard]] const WideBvh& tree() const noexcept { return tracer_.tree(); }

    /// How the tree was built and what it measures.
    [[nodiscard]] const BuildReport& build_report() const noexcept { return report_; }

private:
    TriangleMesh mesh_;
    BuildReport report_;
    WideTracer tracer_;
};

}  // namespace coppice
