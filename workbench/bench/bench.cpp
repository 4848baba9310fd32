// Contestants take turns within one process, so that what disturbs the machine disturbs them alike;
// ratios within one run are what is claimed, and medians are taken against outliers. Only one of
// them has a structure in memory at any time.

#include "bench/bench.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/io/load_mesh.h"

#include "scenes/room_view.h"
#include "scenes/scene_names.h"
#include "text/remaining_time.h"
#include "tracers/contestant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace coppice::lab {

namespace {

constexpr std::string_view preferred_reference = "embree-robust";

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// A contestant with all that was measured of it so far.
struct Entry {
    BenchRow row;
    std::unique_ptr<Contestant> contestant;
    std::vector<double> wall_seconds;
    std::vector<double> cpu_seconds;
    std::array<std::vector<double>, 3> trace_seconds;
};

/// What contestants found: closest hits, or for shadow rays whether there is any.
struct Answers {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> flags;
};

/// Neighbours of one image start next to each other, and primary and shadow rays go the same way.
Queries queries_for(RayKind kind, bool is_batched) {
    if (!is_batched) return Queries::single;
    return kind == RayKind::diffuse ? Queries::batched : Queries::coherent;
}

/// Traces all rays of one kind with at most so many threads.
void trace(const Contestant& contestant, RayKind kind, std::span<const Ray> rays, Queries queries,
           int threads, Answers& answers) {
    constexpr std::size_t chunk_size = 4096;
    const bool is_any_hit = kind == RayKind::shadow;
    answers.hits.resize(is_any_hit ? 0 : rays.size());
    answers.flags.resize(is_any_hit ? rays.size() : 0);
    run_with_threads(threads, [&] {
        parallel_for_chunks(rays.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
            const std::size_t count = end - begin;
            const auto chunk = rays.subspan(begin, count);
            if (is_any_hit) {
                contestant.occluded(chunk, std::span(answers.flags).subspan(begin, count), queries);
            } else {
                contestant.intersect(chunk, std::span(answers.hits).subspan(begin, count), queries);
            }
        });
    });
}

bool is_same(const Hit& a, const Hit& b) {
    if (!a.is_hit() || !b.is_hit()) return a.is_hit() == b.is_hit();
    return std::abs(a.t - b.t) <= 1e-5F * std::max(std::abs(a.t), std::abs(b.t));
}

std::uint64_t count_mismatches(const Answers& answers, const Answers& expected) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < expected.hits.size(); ++i) {
        count += is_same(answers.hits[i], expected.hits[i]) ? 0 : 1;
    }
    for (std::size_t i = 0; i < expected.flags.size(); ++i) {
        count += answers.flags[i] == expected.flags[i] ? 0 : 1;
    }
    return count;
}

std::size_t index_of(RayKind kind) {
    return static_cast<std::size_t>(kind);
}

/// What all scenes of a run share.
struct Run {
    const BenchOptions& options;
    const BenchObserver& observer;
    RemainingTime remaining;

    void tell(const std::string& step) const {
        if (observer.on_progress) observer.on_progress(step, remaining.seconds());
    }

    [[nodiscard]] std::size_t contestant_count() const {
        return options.methods.size() + options.peers.size();
    }

    /// A turn's work, for the remaining time: the size of the scene and the number of rays.
    [[nodiscard]] double work_of_turn(std::uint64_t triangle_count) const {
        const double pixel_count = static_cast<double>(options.size) * options.size;
        return static_cast<double>(triangle_count) +
               pixel_count * static_cast<double>(options.rays.size());
    }
};

/// One scene with one number of threads after the other.
class SceneBench {
public:
    SceneBench(Run& run, BenchScene& scene, TriangleMeshView mesh)
        : run_(run), scene_(scene), mesh_(mesh) {
        const Aabb box = bounds_of(mesh.vertices());
        scene_.camera = choose_ray_camera(mesh, run.options.camera, run.options.threads.front());
        scene_.light = render::place_light(scene_.camera, box);
        rays_[index_of(RayKind::primary)] = primary_rays(scene_.camera, run.options.size);
    }

    std::vector<BenchRow> run_all() {
        std::vector<BenchRow> rows;
        for (const int threads : run_.options.threads) {
            // All of them anew: Embree's devices settle the threads of the process.
            std::vector<Entry> entries = make_entries(threads);
            run_first_round(entries);
            for (int run = 1; run <= run_.options.runs; ++run) {
                for (Entry* entry : take_turns(entries)) {
                    measure(*entry, run);
                }
            }
            for (Entry& entry : entries) {
                rows.push_back(finished_row(entry));
            }
        }
        return rows;
    }

private:
    [[nodiscard]] std::vector<Entry> make_entries(int threads) const {
        std::vector<Entry> entries;
        const auto add = [&](const std::string& name, bool is_peer,
                             std::unique_ptr<Contestant> contestant) {
            Entry& entry = entries.emplace_back();
            entry.row.scene = scene_.scene;
            entry.row.triangles = scene_.triangles;
            entry.row.method = name;
            entry.row.is_peer = is_peer;
            entry.row.threads = threads;
            entry.contestant = std::move(contestant);
        };
        for (const std::string& name : run_.options.methods) {
            add(name, false,
                make_contestant(find_variant(name), threads, run_.options.memory_limit_bytes));
        }
        for (const std::string& name : run_.options.peers) {
            add(name, true, find_named(peer_registry(), name, "peer").make(threads));
        }
        return entries;
    }

    /// Ours and peers alternately, what is left over behind.
    [[nodiscard]] static std::vector<Entry*> take_turns(std::vector<Entry>& entries) {
        std::array<std::vector<Entry*>, 2> sides;
        for (Entry& entry : entries) {
            sides[entry.row.is_peer ? 1 : 0].push_back(&entry);
        }
        std::vector<Entry*> order;
        for (std::size_t i = 0; order.size() < entries.size(); ++i) {
            for (const auto& side : sides) {
                if (i < side.size()) order.push_back(side[i]);
            }
        }
        return order;
    }

    void run_first_round(std::vector<Entry>& entries) {
        std::vector<Entry*> order = take_turns(entries);
        const auto preferred = std::find_if(order.begin(), order.end(), [](const Entry* entry) {
            return entry->row.method == preferred_reference;
        });
        if (preferred != order.end()) std::rotate(order.begin(), preferred, preferred + 1);
        scene_.reference = order.front()->row.method;
        for (Entry* entry : order) {
            build_first(*entry, entry == order.front());
        }
    }

    /// The first touch: builds, measures the tree, and compares all hits.
    void build_first(Entry& entry, bool is_reference) {
        begin_turn(entry, "first run");
        const Timer timer;
        const BuildFigures figures = build_within_limit(entry);
        const auto triangle_count =
            static_cast<double>(std::max<std::uint64_t>(1, scene_.triangles));
        entry.row.build_seconds_first = figures.wall_seconds;
        entry.row.bytes_per_triangle = static_cast<double>(figures.bytes) / triangle_count;
        entry.row.peak_bytes_per_triangle =
            static_cast<double>(figures.peak_bytes) / triangle_count;
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

    /// Whose limit is passed is not in the builders' message.
    [[nodiscard]] BuildFigures build_within_limit(const Entry& entry) const {
        try {
            return entry.contestant->build(mesh_, true);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::limit) throw;
            throw Error(ErrorCode::limit,
                        fmt::format("{}, {}: {}", scene_.scene, entry.row.method, error.what()));
        }
    }

    /// Traces one kind of rays and compares the answers; the reference's become those expected, and
    /// its primary hits the origins of all other rays.
    void compare(Entry& entry, RayKind kind, bool is_reference) {
        const bool is_asked = asks_for(kind);
        const bool makes_rays = is_reference && kind == RayKind::primary;
        if (!is_asked && !makes_rays) return;
        const std::size_t index = index_of(kind);
        Answers answers;
        trace(*entry.contestant, kind, rays_[index], queries_for(kind, run_.options.is_batched),
              entry.row.threads, answers);
        if (makes_rays) make_secondary_rays(answers.hits);
        if (is_reference) {
            expected_[index] = std::move(answers);
        } else {
            entry.row.mismatches += count_mismatches(answers, expected_[index]);
        }
    }

    void make_secondary_rays(std::span<const Hit> hits) {
        const std::span<const Ray> primary = rays_[index_of(RayKind::primary)];
        if (asks_for(RayKind::shadow)) {
            rays_[index_of(RayKind::shadow)] = shadow_rays(mesh_, primary, hits, scene_.light);
        }
        if (asks_for(RayKind::diffuse)) {
            rays_[index_of(RayKind::diffuse)] =
                diffuse_rays(mesh_, primary, hits, run_.options.seed);
        }
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            scene_.ray_counts[i] = rays_[i].size();
        }
    }

    /// One measured turn of one contestant.
    void measure(Entry& entry, int run) {
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

    void measure_tracing(Entry& entry, RayKind kind) {
        const std::span<const Ray> rays = rays_[index_of(kind)];
        const Queries queries = queries_for(kind, run_.options.is_batched);
        const std::size_t warm_up_count = rays.size() / 16;
        trace(*entry.contestant, kind, rays.first(warm_up_count), queries, entry.row.threads,
              answers_);
        answers_.hits.resize(rays.size());  // no page is touched first while the clock runs
        answers_.flags.resize(rays.size());
        const Timer timer;
        trace(*entry.contestant, kind, rays, queries, entry.row.threads, answers_);
        entry.trace_seconds[index_of(kind)].push_back(timer.seconds());
    }

    void begin_turn(const Entry& entry, const std::string& what) const {
        run_.tell(fmt::format("{}, {} thread{}: {}, {}", scene_.scene, entry.row.threads,
                              entry.row.threads == 1 ? "" : "s", entry.row.method, what));
    }

    void end_turn(Entry& entry, const Timer& timer) {
        entry.contestant->clear();
        run_.remaining.finish(run_.work_of_turn(scene_.triangles), timer.seconds());
    }

    [[nodiscard]] BenchRow finished_row(const Entry& entry) const {
        BenchRow row = entry.row;
        row.build_seconds = median(entry.wall_seconds);
        row.build_cpu_seconds = median(entry.cpu_seconds);
        for (const RayKind kind : run_.options.rays) {
            const std::size_t index = index_of(kind);
            if (rays_[index].empty()) continue;  // nothing was hit that a ray could start from
            row.mrays[index] = 1e-6 * static_cast<double>(rays_[index].size()) /
                               median(entry.trace_seconds[index]);
        }
        row.scatter = scatter_of(entry);
        return row;
    }

    /// Of what each run took to trace all rays.
    [[nodiscard]] static double scatter_of(const Entry& entry) {
        std::vector<double> totals(entry.wall_seconds.size(), 0.0);
        for (const std::vector<double>& runs : entry.trace_seconds) {
            for (std::size_t i = 0; i < runs.size(); ++i) {
                totals[i] += runs[i];
            }
        }
        const auto [least, most] = std::minmax_element(totals.begin(), totals.end());
        const double middle = median(totals);
        return middle > 0.0 ? 0.5 * (*most - *least) / middle : 0.0;
    }

    [[nodiscard]] bool asks_for(RayKind kind) const {
        const auto& asked = run_.options.rays;
        return std::find(asked.begin(), asked.end(), kind) != asked.end();
    }

    Run& run_;
    BenchScene& scene_;
    TriangleMeshView mesh_;
    std::array<std::vector<Ray>, 3> rays_;
    std::array<Answers, 3> expected_;
    Answers answers_;
};

TriangleMesh load_scene(const Run& run, BenchScene& scene) {
    run.tell(scene.scene + ": loading");
    TriangleMesh mesh = load_mesh(scene.file);
    if (mesh.triangles.empty()) {
        throw file_error(ErrorCode::unsupported, scene.file.string(),
                         "no triangles: there is nothing to trace");
    }
    scene.triangles = mesh.triangles.size();
    return mesh;
}

void plan(Run& run, const BenchScene& scene) {
    const auto turn_count = run.contestant_count() * run.options.threads.size() *
                            static_cast<std::size_t>(run.options.runs + 1);
    run.remaining.plan(run.work_of_turn(scene.triangles) * static_cast<double>(turn_count));
}

}  // namespace

BenchResult run_bench(const BenchOptions& options, const BenchObserver& observer) {
    check(options);
    Run run{options, observer, {}};
    BenchResult result;
    const std::vector<std::string> names = scene_names(options.scenes);
    for (std::size_t i = 0; i < names.size(); ++i) {
        result.scenes.push_back({.scene = names[i], .file = options.scenes[i]});
    }
    const bool has_several = result.scenes.size() > 1;
    for (BenchScene& scene : result.scenes) {
        if (!has_several) break;
        static_cast<void>(load_scene(run, scene));  // so that a broken file is found in time
        plan(run, scene);
    }
    for (BenchScene& scene : result.scenes) {
        const TriangleMesh mesh = load_scene(run, scene);
        if (!has_several) plan(run, scene);
        const std::vector<BenchRow> rows = SceneBench(run, scene, mesh.view()).run_all();
        if (observer.on_scene) observer.on_scene(scene, rows);
        result.rows.insert(result.rows.end(), rows.begin(), rows.end());
    }
    return result;
}

}  // namespace coppice::lab
