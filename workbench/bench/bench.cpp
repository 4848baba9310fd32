#include "bench/bench.h"

#include "bench/scene_bench.h"
#include "scenes/load_triangles.h"
#include "scenes/scene_names.h"

#include <cstddef>
#include <utility>

namespace coppice::lab {

namespace {

TriangleMesh load_scene(const BenchRun& run, BenchScene& scene) {
    run.tell(scene.scene + ": loading");
    TriangleMesh mesh = load_triangles(scene.file);
    scene.triangles = mesh.triangles.size();
    return mesh;
}

void plan(BenchRun& run, const BenchScene& scene) {
    const auto turn_count = run.contestant_count() * run.options.threads.size() *
                            static_cast<std::size_t>(run.options.runs + 1);
    run.remaining.plan(run.work_of_turn(scene.triangles) * static_cast<double>(turn_count));
}

}  // namespace

BenchResult run_bench(const BenchOptions& options, const BenchObserver& observer) {
    check(options);
    BenchRun run{options, observer, {}};
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
