#pragma once

#include "coppice/geom/ray.h"
#include "coppice/geom/triangle_mesh.h"

#include "tracers/variant.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace coppice::lab {

/// What a build came to.
struct BuildFigures {
    double wall_seconds = 0.0;
    double cpu_seconds = 0.0;
    std::uint64_t bytes = 0;       ///< kept for tracing; the mesh is not counted
    std::uint64_t peak_bytes = 0;  ///< at the height of the build; the mesh is not counted
    std::optional<double> sah_cost;
    std::optional<double> reference_count;
    std::optional<double> sample_share;  ///< of the primitives, in (0, 1]
};

/// How rays are handed to a library: one by one, as an array, or as an array whose neighbours go
/// much the same way, where a library wants to be told.
enum class Queries { single, batched, coherent };

/// A structure to measure: one of our methods or a peer. Built, traced and freed over and over.
class Contestant {
public:
    Contestant() = default;
    Contestant(const Contestant&) = delete;
    Contestant& operator=(const Contestant&) = delete;
    virtual ~Contestant() = default;

    /// Builds for a mesh, which must outlive what is built; call clear() first if there is
    /// something built already. Only building is timed. `is_measured`: the tree is measured too,
    /// which is not timed either; else cost, references and bytes may be those of the last time.
    virtual BuildFigures build(TriangleMeshView mesh, bool is_measured) = 0;

    /// Frees what was built.
    virtual void clear() noexcept = 0;

    /// The closest hit of each ray; t is infinite for a miss. Called from several threads at once.
    virtual void intersect(std::span<const Ray> rays, std::span<Hit> hits,
                           Queries queries) const noexcept = 0;

    /// 1 for each ray that hits anything, else 0. Called from several threads at once.
    virtual void occluded(std::span<const Ray> rays, std::span<std::uint8_t> flags,
                          Queries queries) const noexcept = 0;
};

/// One of our methods, on so many threads. With a limit on what mesh and build may take, a measured
/// build throws Error(limit) if it would pass it, or takes a smaller preset as `auto` does, and so
/// do those after it.
[[nodiscard]] std::unique_ptr<Contestant> make_contestant(const Variant& variant, int threads,
                                                          std::uint64_t memory_limit_bytes = 0);

/// Another library's structure under its name, with one line on what it is.
struct Peer {
    std::string_view name;
    std::string_view summary;
    std::unique_ptr<Contestant> (*make)(int threads);
};

/// The peers that this program was built with; none without Embree.
[[nodiscard]] std::span<const Peer> peer_registry();

}  // namespace coppice::lab
