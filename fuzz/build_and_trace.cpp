// Any triangles, any build, any rays: what is not finite is refused by name, all else is built, is
// sound, and is hit as brute force finds it, to the bit, on every instruction set.

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/builders/split_finder.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/trace/brute_force.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/trace/intersect.h"
#include "coppice/tree/validate.h"

#include "expect.h"
#include "rays.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace coppice::fuzz {
namespace {

template <typename Entry>
const Entry& take_entry(FuzzedDataProvider& data, std::span<const Entry> registry) {
    return registry[data.ConsumeIntegralInRange<std::size_t>(0, registry.size() - 1)];
}

/// A few triangles, some of them many times, each time moved by a step.
TriangleMesh take_mesh(FuzzedDataProvider& data) {
    TriangleMesh mesh;
    const auto vertex_count = data.ConsumeIntegralInRange<std::uint32_t>(1, 48);
    for (std::uint32_t i = 0; i < vertex_count; ++i) {
        mesh.vertices.push_back(take_point(data));
    }
    const auto triangle_count = data.ConsumeIntegralInRange<std::uint32_t>(0, 64);
    for (std::uint32_t i = 0; i < triangle_count; ++i) {
        TriangleIndices& corners = mesh.triangles.emplace_back();
        for (std::uint32_t& corner : corners) {
            corner = data.ConsumeIntegralInRange<std::uint32_t>(0, vertex_count - 1);
        }
    }
    const int times = 1 << data.ConsumeIntegralInRange(0, 4);
    const Vec3f step = take_point(data);
    for (int i = 1; i < times; ++i) {
        const auto moved = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::uint32_t v = 0; v < vertex_count; ++v) {
            mesh.vertices.push_back(mesh.vertices[v] + static_cast<float>(i) * step);
        }
        for (std::uint32_t t = 0; t < triangle_count; ++t) {
            const TriangleIndices& from = mesh.triangles[t];
            mesh.triangles.push_back({from[0] + moved, from[1] + moved, from[2] + moved});
        }
    }
    return mesh;
}

/// The options of both kinds of trees, of which a method takes one.
struct TakenOptions {
    KdOptions kd;
    Bvh8Options bvh8;
};

TakenOptions take_options(FuzzedDataProvider& data, const Method& method) {
    TakenOptions options;
    const bool is_kd = method.tree() == TreeKind::kd;
    is_kd ? void(options.kd = method.kd_options()) : void(options.bvh8 = method.bvh8_options());
    constexpr std::array rates{1.0, 0.5, 0.1, 0.01};
    SampleOptions& sample = is_kd ? options.kd.sample : options.bvh8.sample;
    sample.rate = rates[data.ConsumeIntegralInRange<std::size_t>(0, rates.size() - 1)];
    sample.sampler = take_entry(data, sampler_registry()).name;
    sample.seed = data.ConsumeIntegral<std::uint8_t>();
    options.bvh8.sampled_from = 0;
    options.bvh8.cell_size = data.ConsumeBool() ? 64 : 0;
    options.kd.threads = options.bvh8.threads = data.ConsumeIntegralInRange(1, 2);
    if (data.ConsumeBool()) return options;
    SplitOptions& split = options.kd.split;
    split.rule = take_entry(data, split_finder_registry()).name;
    split.max_leaf = data.ConsumeIntegralInRange<std::uint32_t>(1, 33);
    split.max_depth = data.ConsumeIntegralInRange(0, 60);
    split.clipping = data.ConsumeBool() ? Clipping::perfect : Clipping::bounding_box;
    split.sample_weighting =
        data.ConsumeBool() ? SampleWeighting::sampled : SampleWeighting::expected;
    split.termination = data.ConsumeBool() ? Termination::limits : Termination::sah;
    options.kd.leaf_refinement = data.ConsumeBool() ? LeafRefinement::none : LeafRefinement::kd;
    return options;
}

/// Takes the triangles out that have no finite box; returns the id of the first, or their number.
std::uint32_t drop_what_is_not_finite(TriangleMesh& mesh) {
    const auto are_finite = [&](const TriangleIndices& corners) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](std::uint32_t corner) { return is_finite(mesh.vertices[corner]); });
    };
    const auto first = std::find_if_not(mesh.triangles.begin(), mesh.triangles.end(), are_finite);
    const auto id = static_cast<std::uint32_t>(first - mesh.triangles.begin());
    std::erase_if(mesh.triangles, [&](const TriangleIndices& each) { return !are_finite(each); });
    return id;
}

template <typename Build>
void expect_refusal(Build&& build, std::uint32_t id) {
    try {
        static_cast<void>(build());
    } catch (const Error& error) {
        const std::string what =
            "primitive " + std::to_string(id) + " has a box that is not finite: fix or remove it";
        if (error.what() == what) return;
        std::fprintf(stderr, "found: %s\n", error.what());
    }
    expect(false, "the first triangle that is not finite to be refused by name");
}

/// One traversal against brute force. `all(ray, hits, after)`, `closest`, `any` and `count` as in
/// trace/intersect.h.
template <typename Closest, typename Any, typename All, typename Count>
void expect_true_hits(TriangleMeshView mesh, const Ray& ray, Closest&& closest, Any&& any,
                      All&& all, Count&& count) {
    const auto expected = brute_force_intersect(mesh, ray);
    const auto found = closest(ray);
    expect(found.has_value() == expected.has_value(), "a hit where there is one");
    if (found) {
        expect(found->t == expected->t && found->prim == expected->prim, "the closest hit");
        expect(found->u == expected->u && found->v == expected->v, "its coordinates");
    }
    expect(any(ray) == expected.has_value(), "occlusion where there is a hit");
    expect(count(ray) == brute_force_count_hits(mesh, ray), "all hits counted");
    std::array<Hit, 3> hits;
    std::array<Hit, 3> expected_hits;
    const std::size_t hit_count = all(ray, hits);
    expect(hit_count == brute_force_intersect_all(mesh, ray, expected_hits), "as many hits");
    for (std::size_t i = 0; i < hit_count; ++i) {
        expect(hits[i].t == expected_hits[i].t && hits[i].prim == expected_hits[i].prim,
               "the hits in their order");
    }
}

void check_kd(FuzzedDataProvider& data, TriangleMeshView mesh, const KdOptions& options) {
    const KdTree tree = build_kd_tree(mesh, options).tree;
    expect(validate(tree, mesh, 1).empty(), "a sound k-d tree");
    for (int i = 0; i < 12; ++i) {
        expect_true_hits(
            mesh, take_ray(data, mesh), [&](const Ray& ray) { return intersect(tree, mesh, ray); },
            [&](const Ray& ray) { return occluded(tree, mesh, ray); },
            [&](const Ray& ray, std::span<Hit> hits) {
                return intersect_all(tree, mesh, ray, hits);
            },
            [&](const Ray& ray) { return count_hits(tree, mesh, ray); });
    }
}

/// Eight rays that may be traced together, each against itself alone.
void check_batch(FuzzedDataProvider& data, TriangleMeshView mesh,
                 std::span<const Bvh8Tracer> tracers) {
    std::array<Ray, 8> rays;
    rays.fill(take_ray(data, mesh));
    const Vec3f aside = 0.01F * take_point(data);
    for (std::size_t i = 1; i < rays.size(); ++i) {
        rays[i].direction = rays[i - 1].direction + aside;
        if (data.ConsumeBool()) rays[i].origin = take_target(data, mesh);
    }
    for (const Bvh8Tracer& tracer : tracers) {
        std::array<Hit, 8> hits;
        std::array<std::uint8_t, 8> flags{};
        tracer.intersect(rays, hits);
        tracer.occluded(rays, flags);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Hit expected = tracer.intersect(rays[i]).value_or(Hit{});
            expect(hits[i] == expected, "in a batch the hit of the ray alone");
            expect((flags[i] == 1) == tracer.occluded(rays[i]), "in a batch its occlusion");
        }
    }
}

void check_bvh8(FuzzedDataProvider& data, TriangleMeshView mesh, const Bvh8Options& options) {
    const Bvh8 tree = build_bvh8(mesh, options).tree;
    expect(validate(tree, mesh, 1).empty(), "a sound 8-wide tree");
    std::vector<Bvh8Tracer> tracers;
    for (const Isa isa : available_isas()) {
        tracers.emplace_back(tree, isa);
    }
    for (int i = 0; i < 12; ++i) {
        const Ray any_ray = take_ray(data, mesh);
        for (const Bvh8Tracer& tracer : tracers) {
            expect_true_hits(
                mesh, any_ray, [&](const Ray& ray) { return tracer.intersect(ray); },
                [&](const Ray& ray) { return tracer.occluded(ray); },
                [&](const Ray& ray, std::span<Hit> hits) {
                    return tracer.intersect_all(ray, hits);
                },
                [&](const Ray& ray) { return tracer.count_hits(ray); });
        }
        check_batch(data, mesh, tracers);
    }
}

void check_points(std::span<const Vec3f> points, const KdOptions& options) {
    const PointCloudView view{points};
    try {
        expect(validate(build_kd_tree(view, options).tree, view, 1).empty(),
               "a sound tree of points");
    } catch (const Error& error) {
        expect(error.code() == ErrorCode::invalid_argument, "points that are finite to be taken");
    }
}

void run(FuzzedDataProvider& data) {
    const Method& method = take_entry(data, method_registry());
    const TakenOptions options = take_options(data, method);
    TriangleMesh mesh = take_mesh(data);
    const auto build_kd = [&] { return build_kd_tree(mesh.view(), options.kd).tree; };
    const auto build_wide = [&] { return build_bvh8(mesh.view(), options.bvh8).tree; };
    const bool is_kd = method.tree() == TreeKind::kd;
    TriangleMesh finite = mesh;
    const std::uint32_t first_bad = drop_what_is_not_finite(finite);
    if (first_bad < mesh.triangles.size()) {
        is_kd ? expect_refusal(build_kd, first_bad) : expect_refusal(build_wide, first_bad);
    }
    if (is_kd) {
        check_kd(data, finite.view(), options.kd);
        check_points(finite.vertices, options.kd);
    } else {
        check_bvh8(data, finite.view(), options.bvh8);
    }
}

}  // namespace
}  // namespace coppice::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider provider(data, size);
    coppice::fuzz::run(provider);
    return 0;
}
