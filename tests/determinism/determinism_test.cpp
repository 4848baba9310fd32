// Trees, results and images are the same to the bit for any number of threads, by every instruction
// set, and every time; and trees are those of the release before. Eight threads are eight, also on
// a machine of fewer. The thread sanitizer watches this program (docs/reliability.md).

#include "coppice/base/cpu.h"
#include "coppice/base/parallel.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/store/fingerprint.h"

#include "experiment/experiment.h"
#include "render/integrators/integrators.h"
#include "render/render.h"
#include "scenes/procedural.h"
#include "store/checksum.h"
#include "support/builds.h"
#include "support/effort.h"
#include "support/isa.h"
#include "support/lab_scenes.h"
#include "support/more_threads.h"
#include "tracers/traced_tree.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::test {
namespace {

constexpr std::size_t most_threads = 8;

/// How something may be made that is the same all the same.
struct Way {
    int threads;
    Isa isa;
};

/// Every number of threads with every instruction set, the last one twice.
std::vector<Way> all_ways() {
    std::vector<int> thread_counts{1, 2, 3, 8, 8};
    thread_counts.resize(std::max(2U, static_cast<unsigned>(effort(5))));
    if (std::string_view(tasking_backend()) == "serial") thread_counts = {1, 8};  // one, both times
    std::vector<Way> ways;
    for (const int threads : thread_counts) {
        for (const Isa isa : available_isas()) {
            ways.push_back({threads, isa});
        }
    }
    return ways;
}

/// Calls `make(threads)` in all ways; all results must equal the first, which is returned.
template <typename Make>
auto made_in_all_ways(Make&& make) {
    const MoreThreads allowed(most_threads);
    auto first = make(1);
    for (const Way& way : all_ways()) {
        const ForceIsa force(way.isa);
        EXPECT_TRUE(make(way.threads) == first) << way.threads << " threads, " << name_of(way.isa);
    }
    return first;
}

template <typename Item>
std::uint64_t hash_of(std::span<const Item> items) {
    return checksum(std::as_bytes(items));
}

/// Of all bytes of a tree.
template <typename Tree>
std::uint64_t hash_of(const Tree& tree) {
    std::vector<std::uint64_t> parts{hash_of(tree.nodes()), hash_of(std::span(&tree.bounds(), 1))};
    if constexpr (std::is_same_v<Tree, KdTree>) {
        parts.push_back(hash_of(tree.references()));
    } else {
        parts.push_back(hash_of(tree.blocks()));
    }
    return hash_of(std::span<const std::uint64_t>(parts));
}

std::uint64_t tree_hash(const Method& method, TriangleMeshView mesh, int threads) {
    BuildOptions options = test::options_as_if_large(method, 256);
    set_threads(options, threads);
    return std::visit([](const auto& tree) { return hash_of(tree); },
                      test::build_any(mesh, options).tree);
}

/// A procedural scene, and what its trees are: the scene itself, since that has sines in it that
/// another library may round another way; k-d trees of all methods, 8-wide trees of all methods.
struct Golden {
    const char* scene;
    std::uint64_t mesh;
    std::uint64_t kd;
    std::uint64_t bvh8;
};

void PrintTo(const Golden& golden,  // NOLINT(readability-identifier-naming)
             std::ostream* stream) {
    *stream << golden.scene;
}

class ProceduralScene : public testing::TestWithParam<Golden> {};

// If a change of a builder is meant to change its trees, the new hashes are in the messages.
TEST_P(ProceduralScene, GivesTheGoldenTreesInAllWays) {
    const TriangleMesh mesh = lab::make_procedural(GetParam().scene, 6000, 1);
    const Fingerprint fingerprint = fingerprint_of(mesh.view());
    EXPECT_EQ(fingerprint.vertex_hash, GetParam().mesh);
    std::vector<std::uint64_t> kd;
    std::vector<std::uint64_t> wide;
    for (const Method& method : method_registry()) {
        SCOPED_TRACE(method.name);
        const auto hash =
            made_in_all_ways([&](int threads) { return tree_hash(method, mesh.view(), threads); });
        (method.tree() == TreeKind::kd ? kd : wide).push_back(hash);
    }
    EXPECT_EQ(hash_of(std::span<const std::uint64_t>(kd)), GetParam().kd);
    EXPECT_EQ(hash_of(std::span<const std::uint64_t>(wide)), GetParam().bvh8);
}

TEST_P(ProceduralScene, GivesTheSameImageInAllWays) {
    const TriangleMesh mesh = lab::make_procedural(GetParam().scene, 2000, 1);
    const auto camera = render::frame_box(bounds_of(mesh.vertices), {}, 1.5);
    const MeshAttributes attributes;
    const render::Lighting lighting{.sky = {.color = Vec3f{1, 1, 1}}};
    const auto integrator = render::make_path({});
    made_in_all_ways([&](int threads) {
        Bvh8Options options = find_method("auto").bvh8_options();
        options.threads = threads;
        const lab::TracedTree tracer(mesh.view(), build_bvh8(mesh.view(), options).tree);
        const render::View view{&tracer, mesh.view(), &attributes, &lighting};
        return render::render(view, camera, *integrator,
                              {.width = 30, .height = 20, .samples = 2, .threads = threads})
            .image.pixels;
    });
}

INSTANTIATE_TEST_SUITE_P(
    Seed1, ProceduralScene,
    testing::Values(
        Golden{"terrain", 13124835991470106110U, 3222360181090808809U, 14273782896525238054U},
        Golden{"spheres", 7614836570897974840U, 6333108735452159645U, 4083975192160019654U},
        Golden{"soup", 56903913795368160U, 13858165003774436616U, 15814834287369507220U},
        Golden{"city", 603665496059988380U, 10116706474838037404U, 7185344402833815662U}),
    [](const auto& each) { return std::string(each.param.scene); });

/// Rows without times.
std::string results_text(const std::vector<lab::SceneResult>& scenes) {
    std::string text;
    for (const lab::ResultRow& row : scenes.front().rows) {
        const nlohmann::ordered_json json = lab::row_json(row);
        for (const auto& [column, value] : json.items()) {
            if (column.find("seconds") == std::string::npos) text += value.dump() + ' ';
        }
    }
    return text;
}

TEST(Experiment, GivesTheSameResultsInAllWays) {
    const lab::test::TemporaryFolder folder;
    lab::ExperimentOptions options{.scenes = {folder.make_scene("scene.ply", "spheres", 1500)},
                                   .percents = {100, 10},
                                   .seed_count = 2};
    const std::string results = made_in_all_ways([&](int threads) {
        options.build.threads = threads;
        return results_text(lab::run_experiment(options));
    });
    EXPECT_NE(results, "");
}

}  // namespace
}  // namespace coppice::test
