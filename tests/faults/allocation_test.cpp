// Memory that runs out: the n-th allocation of an operation fails, for n from the first to the
// last. What comes of it is an error that a caller can catch, and nothing is leaked.

#include "coppice/base/error.h"
#include "coppice/builders/build_tree.h"
#include "coppice/builders/estimate.h"
#include "coppice/builders/method.h"
#include "coppice/io/load_mesh.h"
#include "coppice/io/save_mesh.h"
#include "coppice/scene/scene.h"
#include "coppice/store/tree_file.h"

#include "base/out_of_memory.h"
#include "io/test_files.h"
#include "support/builds.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <string>

namespace coppice::test {
namespace {

/// What operator new and aligned_alloc (for BigBuffer) count, in all threads.
struct Allocations {
    static constexpr long never = std::numeric_limits<long>::max();
    std::atomic<long> until_failure{never};
    std::atomic<bool> has_failed{false};
    std::atomic<long> made{0};
    std::atomic<long> alive{0};
};

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): operator new has no other
constinit Allocations allocations;

bool is_to_fail() {
    ++allocations.made;
    if (allocations.until_failure.fetch_sub(1) != 0) return false;
    allocations.has_failed = true;
    return true;
}

void* allocate(std::size_t size, std::size_t alignment) {
    void* memory = nullptr;
    if (is_to_fail() || posix_memalign(&memory, alignment, size) != 0) throw std::bad_alloc();
    ++allocations.alive;
    return memory;
}

void release(void* memory) noexcept {
    if (memory != nullptr) --allocations.alive;
    std::free(memory);
}

/// Fails allocations of `work` one after the other, at most about `most` of them.
void fail_each(const std::function<void()>& work, long most = 15) {
    allocations.until_failure = Allocations::never;
    work();  // what is made once and kept, by us or by others
    const long before = allocations.made;
    work();
    const long count = allocations.made - before;
    ASSERT_GT(count, 0);
    const long step = std::max(1L, count / most);
    long surfaced = 0;
    for (long n = 0; n < count; n += step) {
        SCOPED_TRACE("failure " + std::to_string(n) + " of " + std::to_string(count));
        const long alive = allocations.alive;
        allocations.has_failed = false;
        allocations.until_failure = n;
        bool has_surfaced = false;
        try {
            work();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::out_of_memory) << error.what();
            has_surfaced = true;
        } catch (const std::bad_alloc&) {
            ADD_FAILURE() << "not told as an error";
        }
        allocations.until_failure = Allocations::never;
        // With two threads the last numbers may not come up: then nothing has failed.
        const long alive_after = allocations.alive;  // before a failed expectation allocates
        EXPECT_EQ(has_surfaced, allocations.has_failed) << "a failed allocation must surface";
        EXPECT_EQ(alive_after, alive) << "leaked";
        surfaced += has_surfaced ? 1 : 0;
    }
    EXPECT_GT(surfaced, 0);
}

class FailingBuild : public testing::TestWithParam<Method> {};

TEST_P(FailingBuild, IsAnError) {
    const TriangleMesh mesh = make_soup(3000, 0.05F, 1);
    const Method& method = GetParam();
    BuildOptions options = options_as_if_large(method, 256);
    for (const int threads : {1, 2}) {
        set_threads(options, threads);
        fail_each([&] { static_cast<void>(build_any(mesh.view(), options)); });
    }
}

INSTANTIATE_TEST_SUITE_P(Method, FailingBuild,
                         testing::ValuesIn(method_registry().begin(), method_registry().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(FailingAllocation, OfAnEstimateIsAnError) {
    const TriangleMesh mesh = make_soup(20'000, 0.05F, 1);
    fail_each([&] { static_cast<void>(estimate_kd_tree(mesh.view(), {})); }, 8);
}

TEST(FailingAllocation, OfLoadingIsAnError) {
    const std::filesystem::path data = COPPICE_TEST_DATA_DIR;
    for (const char* name :
         {"bunny.obj", "tetrahedron.obj", "tetrahedron.ply", "tetrahedron.off"}) {
        SCOPED_TRACE(name);
        const std::filesystem::path file = data / name;
        fail_each([&] {
            LoadReport report;
            static_cast<void>(load_mesh(file, &report));
        });
    }
}

TEST(FailingAllocation, OfTracingAndSearchingIsAnError) {
    const Scene scene(make_soup(3000, 0.05F, 1));
    const std::vector<Ray> rays(5000, Ray{.origin = {0.5F, 0.5F, -1.0F}, .direction = {0, 0, 1}});
    std::vector<Hit> hits(rays.size());
    fail_each([&] {
        const Scene copy(
            with_memory_errors("the caller's copy", [&] { return TriangleMesh(scene.mesh()); }));
        copy.intersect(rays, hits, 2);
        static_cast<void>(copy.nearest({0.1F, 0.2F, 0.3F}));
    });
}

TEST(FailingAllocation, OfSavingAndLoadingATreeIsAnErrorAndLeavesNoFile) {
    const TriangleMesh mesh = make_soup(500, 0.1F, 1);
    const Fingerprint primitives = fingerprint_of(mesh.view());
    const std::filesystem::path folder = fresh_folder();
    const std::filesystem::path bvh8_file = folder / "wide.cpk";
    const std::filesystem::path kd_file = folder / "kd.cpk";
    const std::filesystem::path mesh_file = folder / "mesh.ply";
    const Bvh8 wide = build_bvh8(mesh.view(), {}).tree;
    const KdTree kd = build_kd_tree(mesh.view(), {}).tree;
    fail_each([&] {
        save_tree(bvh8_file, wide, primitives);
        save_tree(kd_file, kd, primitives);
        static_cast<void>(load_tree(bvh8_file, primitives));
        static_cast<void>(load_tree(kd_file));
        save_mesh(mesh.view(), mesh_file);
    });
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        left.push_back(entry.path().filename().string());
    }
    std::sort(left.begin(), left.end());
    EXPECT_EQ(left, (std::vector<std::string>{"kd.cpk", "mesh.ply", "wide.cpk"}));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace coppice::test

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    void* memory = nullptr;
    const bool has_failed =
        coppice::test::is_to_fail() || posix_memalign(&memory, alignment, size) != 0;
    return has_failed ? nullptr : memory;
}

void* operator new(std::size_t size) {
    return coppice::test::allocate(size, alignof(std::max_align_t));
}

// Who asks this way can do without (std::stable_sort): it never fails.
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
    void* const memory = std::malloc(size);
    if (memory != nullptr) ++coppice::test::allocations.alive;
    return memory;
}

void* operator new(std::size_t size, std::align_val_t alignment) {
    return coppice::test::allocate(size, static_cast<std::size_t>(alignment));
}

void operator delete(void* memory) noexcept {
    coppice::test::release(memory);
}

void operator delete(void* memory, std::size_t /*size*/) noexcept {
    coppice::test::release(memory);
}

void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
    coppice::test::release(memory);
}

void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
    coppice::test::release(memory);
}
