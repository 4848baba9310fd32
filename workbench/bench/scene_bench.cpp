// Contestants take turns within one process: what disturbs the machine disturbs them alike. Only
// ratios within one run are claimed, and medians keep outliers out. Only one contestant has a
// structure in memory at any time.

#include "bench/scene_bench.h"

#include "coppice/base/error.h"

#include "scenes/room_view.h"
#include "text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace coppice::lab {

namespace {

constexpr std::string_view preferred_reference = "embree-robust";

}  // namespace

SceneBench::SceneBench(BenchRun& run, BenchScene& scene, TriangleMeshView mesh)
    : run_(run), scene_(scene), mesh_(mesh) {
    const Aabb box = bounds_of(mesh.vertices());
    scene_.camera = choose_ray_camera(mesh, run.options.camera, run.options.threads.front());
    scene_.light = render::place_light(scene_.camera, box);
    rays_[index_of(RayKind::primary)] = primary_rays(scene_.camera, run.options.size);
}

std::vector<BenchRow> SceneBench::run_all() {
    std::vector<BenchRow> rows;
    for (const int threads : run_.options.threads) {
        // Made anew for each number: an Embree device fixes the number of threads.
        std::vector<BenchEntry> entries = make_entries(run_.options, scene_, threads);
        run_first_round(entries);
        for (int run = 1; run <= run_.options.runs; ++run) {
            for (BenchEntry* entry : take_turns(entries)) {
                measure(*entry, run);
            }
        }
        for (BenchEntry& entry : entries) {
            rows.push_back(finished_row(entry, run_.options.rays, scene_.ray_counts));
        }
    }
    return rows;
}

void SceneBench::run_first_round(std::vector<BenchEntry>& entries) {
    std::vector<BenchEntry*> order = take_turns(entries);
    const auto preferred = std::find_if(order.begin(), order.end(), [](const BenchEntry* entry) {
        return entry->row.method == preferred_reference;
    });
    if (preferred != order.end()) std::rotate(order.begin(), preferred, preferred + 1);
    scene_.reference = order.front()->row.method;
    for (BenchEntry* entry : order) {
        build_first(*entry, entry == order.front());
    }
}

/// The first touch: builds, measures the tree, and compares all hits.
void SceneBench::build_first(BenchEntry& entry, bool is_reference) {
    begin_turn(entry, "first run");
    const Timer timer;
    const BuildFigures figures = build_within_limit(entry);
    const auto triangle_count = static_cast<double>(std::max<std::uint64_t>(1, scene_.triangles));
    entry.row.build_seconds_first = figures.wall_seconds;
    entry.row.bytes_per_triangle = static_cast<double>(figures.bytes) / triangle_count;
    entry.row.peak_bytes_per_triangle = static_cast<double>(figures.peak_bytes) / triangle_count;
    entry.row.sah_cost = figures.sah_cost;
    entry.row.sample_share = figures.sample_share;
    if (figures.reference_count) {
        entry.row.references_per_triangle = *figures.reference_count / triangle_count;
    }
    for (const RayKindEntry& kind : rendering_ray_kinds()) {
        compare(entry, kind.kind, is_reference);
    }
    end_turn(entry, timer);
}

/// Adds the scene and the contestant to the message: the builder knows neither.
BuildFigures SceneBench::build_within_limit(const BenchEntry& entry) const {
    try {
        return entry.contestant->build(mesh_, true);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::limit) throw;
        throw Error(ErrorCode::limit,
                    fmt::format("{}, {}: {}", scene_.scene, entry.row.method, error.what()));
    }
}

/// Traces one kind of rays. The answers of the reference are kept, and its primary hits become the
/// origins of all other rays; those of other contestants are compared with them.
void SceneBench::compare(BenchEntry& entry, RayKind kind, bool is_reference) {
    const bool is_asked = asks_for(kind);
    const bool makes_rays = is_reference && kind == RayKind::primary;
    if (!is_asked && !makes_rays) return;
    const std::size_t index = index_of(kind);
    Answers answers;
    trace_answers(*entry.contestant, kind, rays_[index], queries_for(kind, run_.options.is_batched),
                  entry.row.threads, answers);
    if (makes_rays) make_secondary_rays(answers.hits);
    if (is_reference) {
        expected_[index] = std::move(answers);
    } else {
        entry.row.mismatches += count_mismatches(answers, expected_[index]);
    }
}

void SceneBench::make_secondary_rays(std::span<const Hit> hits) {
    const std::span<const Ray> primary = rays_[index_of(RayKind::primary)];
    if (asks_for(RayKind::shadow)) {
        rays_[index_of(RayKind::shadow)] = shadow_rays(mesh_, primary, hits, scene_.light);
    }
    if (asks_for(RayKind::diffuse)) {
        rays_[index_of(RayKind::diffuse)] = diffuse_rays(mesh_, primary, hits, run_.options.seed);
    }
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        scene_.ray_counts[i] = rays_[i].size();
    }
}

/// One measured turn of one contestant.
void SceneBench::measure(BenchEntry& entry, int run) {
    begin_turn(entry, fmt::format("run {} of {}", run, run_.options.runs));
    const Timer timer;
    const BuildFigures figures = entry.contestant->build(mesh_, false);
    entry.wall_seconds.push_back(figures.wall_seconds);
    entry.cpu_seconds.push_back(figures.cpu_seconds);
    for (const RayKind kind : run_.options.rays) {
        measure_tracing(entry, kind);
    }
    end_turn(entry, timer);
}

void SceneBench::measure_tracing(BenchEntry& entry, RayKind kind) {
    const std::span<const Ray> rays = rays_[index_of(kind)];
    const Queries queries = queries_for(kind, run_.options.is_batched);
    const std::size_t warm_up_count = rays.size() / 16;
    trace_answers(*entry.contestant, kind, rays.first(warm_up_count), queries, entry.row.threads,
                  answers_);
    answers_.hits.resize(rays.size());  // pages are touched before the clock runs
    answers_.flags.resize(rays.size());
    const Timer timer;
    trace_answers(*entry.contestant, kind, rays, queries, entry.row.threads, answers_);
    entry.trace_seconds[index_of(kind)].push_back(timer.seconds());
}

void SceneBench::begin_turn(const BenchEntry& entry, const std::string& what) const {
    run_.tell(fmt::format("{}, {}: {}, {}", scene_.scene,
                          count_text(static_cast<std::uint64_t>(entry.row.threads), "thread"),
                          entry.row.method, what));
}

void SceneBench::end_turn(BenchEntry& entry, const Timer& timer) {
    entry.contestant->clear();
    run_.remaining.finish(run_.work_of_turn(scene_.triangles), timer.seconds());
}

bool SceneBench::asks_for(RayKind kind) const {
    const auto& asked = run_.options.rays;
    return std::find(asked.begin(), asked.end(), kind) != asked.end();
}

}  // namespace coppice::lab
