#include "builders/bvh8/spatial_splitter.h"

#include "coppice/base/rng.h"

#include "builders/bvh8/make_prim_refs.h"
#include "support/isa.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <span>
#include <vector>

namespace coppice::bvh8 {
namespace {

using test::joined;
using test::make_slivers;
using test::make_soup;
using test::scaled;

// Small triangles and long ones among them, of which many are cut.
TriangleMesh make_mixture(std::uint64_t seed) {
    return joined(make_soup(5000, 0.02F, seed), make_slivers(1000, 1.0F, seed));
}

// All pieces of a mesh's triangles after splits that go down to some hundred prim_refs.
class Cutter {
public:
    Cutter(const TriangleMesh& mesh, double room, Isa isa)
        : first_(static_cast<std::size_t>(room * static_cast<double>(mesh.triangles.size()))),
          second_(first_.size()) {
        const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
        make_prim_refs(mesh.view(), std::span(first_).first(count));
        Range all = Splitter(first_, second_, {}, kernels_for(isa)).measured(0, count, 0);
        all.spare_above = static_cast<std::uint32_t>(first_.size()) - count;
        const SplitCosts costs{8.0F, true, extent_factor_of(all.box)};
        const Splitter splitter(first_, second_, costs, kernels_for(isa));
        const SpatialSplitter spatial(first_, second_, mesh.view(), all.box, kernels_for(isa));
        cut(all, splitter, spatial);
    }

    [[nodiscard]] const std::vector<PrimRef>& pieces() const { return pieces_; }

private:
    void cut(const Range& range, const Splitter& splitter, const SpatialSplitter& spatial) {
        BinMapping mapping{};
        const ObjectSplit split = splitter.find(range, mapping);
        auto halves = spatial.improve(range, split);
        if (!halves && range.size() < 512) {
            const auto prim_refs = splitter.prim_refs(range);
            pieces_.insert(pieces_.end(), prim_refs.begin(), prim_refs.end());
            return;
        }
        if (!halves) halves = splitter.divide(range, split, mapping);
        for (const Range& half : {halves->lower, halves->upper}) {
            EXPECT_LT(half.size(), range.size());
            const Range measured = splitter.measured(half.begin, half.end, half.buffer);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(half.box.lower(axis), measured.box.lower(axis));
                EXPECT_EQ(half.box.upper(axis), measured.box.upper(axis));
                EXPECT_EQ(half.centroids.lower(axis), measured.centroids.lower(axis));
                EXPECT_EQ(half.centroids.upper(axis), measured.centroids.upper(axis));
            }
        }
        EXPECT_EQ(halves->lower.room() + halves->upper.room(), range.room());
        cut(halves->lower, splitter, spatial);
        cut(halves->upper, splitter, spatial);
    }

    std::vector<PrimRef> first_;
    std::vector<PrimRef> second_;
    std::vector<PrimRef> pieces_;
};

// Up to what the test rounds itself.
bool contains(const PrimRef& piece, const std::array<float, 3>& point) {
    constexpr float slack = 1e-6F;
    bool is_inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        is_inside &= -piece.negated_lower[axis] <= point[axis] + slack &&
                     point[axis] - slack <= piece.upper[axis];
    }
    return is_inside;
}

// Points on triangles that are in none of their pieces.
int count_lost_points(const TriangleMesh& mesh, const std::vector<PrimRef>& pieces) {
    std::multimap<std::uint32_t, PrimRef> by_id;
    for (const PrimRef& piece : pieces) {
        by_id.emplace(piece.id, piece);
    }
    int lost = 0;
    for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
        const auto [a, b, c] = mesh.view().triangle(id);
        for (std::uint64_t i = 0; i < 20; ++i) {
            // Corners and points of edges among them.
            const auto u = static_cast<float>(random_unit(id, 2 * i));
            const float v =
                i % 4 == 0 ? 0.0F : (1.0F - u) * static_cast<float>(random_unit(id, 2 * i + 1));
            const Vec3f point = i == 0 ? a : a + u * (b - a) + v * (c - a);
            bool is_kept = false;
            const auto [begin, end] = by_id.equal_range(id);
            for (auto at = begin; at != end; ++at) {
                is_kept |= contains(at->second, {point.x, point.y, point.z});
            }
            lost += is_kept ? 0 : 1;
        }
    }
    return lost;
}

TEST(SpatialSplitter, PiecesHoldAllOfTheirTriangles) {
    const TriangleMesh mesh = make_mixture(5);
    for (const Isa isa : available_isas()) {
        const Cutter cutter(mesh, 1.5, isa);
        EXPECT_GT(cutter.pieces().size(), 7000U);
        EXPECT_LE(cutter.pieces().size(), 9000U);
        EXPECT_EQ(count_lost_points(mesh, cutter.pieces()), 0) << name_of(isa);
    }
}

TEST(SpatialSplitter, IsTheSameForAllInstructionSets) {
    const TriangleMesh mesh = make_mixture(6);
    const auto expected = Cutter(mesh, 1.3, Isa::scalar).pieces();
    for (const Isa isa : available_isas()) {
        const auto pieces = Cutter(mesh, 1.3, isa).pieces();
        ASSERT_EQ(pieces.size(), expected.size());
        EXPECT_EQ(std::memcmp(pieces.data(), expected.data(), pieces.size() * sizeof(PrimRef)), 0)
            << name_of(isa);
    }
}

TEST(SpatialSplitter, CutsNothingWithoutRoom) {
    const TriangleMesh mesh = make_soup(2000, 0.4F, 7);
    EXPECT_EQ(Cutter(mesh, 1.0, Isa::scalar).pieces().size(), 2000U);
}

TEST(SpatialSplitter, CutsNothingWhereItCouldOverflow) {
    const TriangleMesh mesh = scaled(make_soup(2000, 0.4F, 7), 1e36F);
    EXPECT_EQ(Cutter(mesh, 1.5, Isa::scalar).pieces().size(), 2000U);
}

}  // namespace
}  // namespace coppice::bvh8
