// Builds the top tree of an 8-wide tree from a sample, and distributes all PrimRefs to its cells.
// The top tree is a binary tree of object splits over the sampled PrimRefs, each weighted by 1/p in
// the costs. A cell receives the PrimRefs with their centroid in it, so that nothing is cut and
// boxes grow to fit. The descent uses branches: meshes are coherent, and predictable branches cost
// less than the arithmetic that avoids them. Cost: sample size times its depth, then N times the
// depth of the top tree.
// Source: [Tessari2023] sec. 3, [Wald2007] sec. 3.

#include "coppice/base/parallel.h"

#include "builders/bvh8/cells.h"
#include "builders/chunk_sizes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace coppice::inline v0::bvh8 {
namespace {

// Nodes of fewer sampled PrimRefs are not split: the sample is too small to choose a plane.
constexpr std::uint32_t min_sampled = 8;

// Half of the greatest depth of an 8-wide tree. Only adversarial scenes come near it.
constexpr int max_top_depth = 32;

float weight_of(std::span<const PrimRef> prim_refs) {
    float sum = 0.0F;
    for (const PrimRef& prim_ref : prim_refs) {
        sum += prim_ref.weight;
    }
    return sum;
}

class TopBuilder {
public:
    TopBuilder(const Splitter& splitter, float cell_size)
        : splitter_(splitter), cell_size_(cell_size) {}

    void build(std::uint32_t slot, const Range& range, int depth) {
        BinMapping mapping{};
        const bool is_small = depth == max_top_depth || range.size() < 2 * min_sampled ||
                              weight_of(splitter_.prim_refs(range)) <= cell_size_;
        const ObjectSplit split = is_small ? ObjectSplit{} : splitter_.find(range, mapping);
        if (split.bin == 0) return;
        const Halves halves = splitter_.divide(range, split, mapping);
        const std::uint32_t lower = top_.split(
            slot, {static_cast<Axis>(split.axis), mapping.begin_of(split.axis, split.bin)},
            PlanarSide::above);
        build(lower, halves.lower, depth + 1);
        build(lower + 1, halves.upper, depth + 1);
    }

    [[nodiscard]] TopTree take() && {
        top_.number_cells();
        return std::move(top_);
    }

private:
    const Splitter& splitter_;
    float cell_size_;
    TopTree top_;
};

// Finds cells without descending from the root. Meshes are coherent, so a PrimRef is usually in the
// cell of the one before. Otherwise, a grid over the sampled centroids gives for each voxel the
// deepest node that contains it, and the descent starts there.
class Shortcuts {
public:
    // A cell and the sums of bounds that belong to it: lower <= sum < upper on every axis.
    struct Place {
        std::uint32_t cell = 0;
        std::array<float, 3> lower{infinity, infinity, infinity};
        std::array<float, 3> upper{-infinity, -infinity, -infinity};
    };

    explicit Shortcuts(const ObjectTop& top)
        : top_(top.tree),
          places_(top.tree.cell_count()),
          starts_(resolution * resolution * resolution) {
        place_cells(0, {0, {-infinity, -infinity, -infinity}, {infinity, infinity, infinity}});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            origin_[axis] = top.centroids.lower(axis);
            const float extent = top.centroids.upper(axis) - origin_[axis];
            const float scale = static_cast<float>(resolution) / extent;
            scale_[axis] = std::isfinite(scale) ? scale : 0.0F;
        }
        for (std::size_t voxel = 0; voxel < starts_.size(); ++voxel) {
            starts_[voxel] = deepest_node_over(voxel);
        }
    }

    // Sets `place` to the place of a PrimRef. It may be that already.
    void find(const PrimRef& prim_ref, Place& place) const {
        std::array<float, 3> sum;
        bool is_same = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sum[axis] = prim_ref.upper[axis] - prim_ref.negated_lower[axis];
            is_same &= (sum[axis] >= place.lower[axis]) & (sum[axis] < place.upper[axis]);
        }
        if (!is_same) place = places_[cell_of(sum)];
    }

private:
    static constexpr std::size_t resolution = 32;
    static constexpr float infinity = std::numeric_limits<float>::infinity();

    void place_cells(std::uint32_t index, Place place) {
        const TopTree::Node& node = top_.nodes()[index];
        if (node.is_cell) {
            place.cell = node.index;
            places_[node.index] = place;
            return;
        }
        Place lower = place;
        lower.upper[axis_of(node)] = node.plane.position;
        place.lower[axis_of(node)] = node.plane.position;
        place_cells(node.index, lower);
        place_cells(node.index + 1, place);
    }

    [[nodiscard]] std::uint32_t cell_of(const std::array<float, 3>& sum) const {
        std::size_t voxel = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float at = (sum[axis] - origin_[axis]) * scale_[axis];
            constexpr auto last = static_cast<float>(resolution - 1);
            const float clamped = std::max(0.0F, at < last ? at : last);
            voxel = voxel * resolution + static_cast<std::size_t>(clamped);
        }
        const std::uint32_t end = top_.descend(starts_[voxel], [&](const TopTree::Node& node) {
            return sum[axis_of(node)] < node.plane.position ? TopTree::Step::below
                                                            : TopTree::Step::above;
        });
        return top_.nodes()[end].index;
    }

    [[nodiscard]] std::uint32_t deepest_node_over(std::size_t voxel) const {
        const std::array<std::size_t, 3> at{voxel / (resolution * resolution),
                                            voxel / resolution % resolution, voxel % resolution};
        return top_.descend(0, [&](const TopTree::Node& node) {
            const std::size_t axis = axis_of(node);
            const float place = (node.plane.position - origin_[axis]) * scale_[axis];
            const auto begin = static_cast<float>(at[axis]);
            // Widened by a voxel, because positions in the grid are rounded.
            if (place <= begin - 1.0F && scale_[axis] > 0.0F) return TopTree::Step::above;
            return place >= begin + 2.0F ? TopTree::Step::below : TopTree::Step::nowhere;
        });
    }

    static std::size_t axis_of(const TopTree::Node& node) {
        return static_cast<std::size_t>(node.plane.axis);
    }

    const TopTree& top_;
    std::vector<Place> places_;  // one per cell
    std::array<float, 3> origin_{};
    std::array<float, 3> scale_{};
    std::vector<std::uint32_t> starts_;
};

}  // namespace

ObjectTop build_object_top(std::span<PrimRef> sample, float cell_size, const Kernels& kernels) {
    std::vector<PrimRef> buffer(sample.size());
    Splitter measure(sample, buffer, {}, kernels);
    const Range all = measure.measured(0, static_cast<std::uint32_t>(sample.size()), 0);
    const Splitter splitter(sample, buffer, {8.0F, false, extent_factor_of(all.box)}, kernels);
    TopBuilder builder(splitter, cell_size);
    builder.build(0, all, 0);
    return {std::move(builder).take(), all.centroids};
}

std::vector<Range> fill_cells(const ObjectTop& top, std::span<PrimRef> from,
                              std::span<PrimRef> to) {
    // Chunks depend on the sizes alone: enough for parallelism, few enough to keep their counts
    // small.
    const std::size_t chunk_size = std::max(primitives_per_task, from.size() / 64);
    const std::size_t chunk_count = (from.size() + chunk_size - 1) / chunk_size;
    const std::size_t cell_count = top.tree.cell_count();
    std::vector<std::uint32_t> places(chunk_count * cell_count);  // [chunk][cell]

    const Shortcuts shortcuts(top);
    parallel_for_chunks(from.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        std::uint32_t* counts = &places[begin / chunk_size * cell_count];
        Shortcuts::Place place;
        for (PrimRef& prim_ref : from.subspan(begin, end - begin)) {
            shortcuts.find(prim_ref, place);
            const std::uint32_t cell = place.cell;
            prim_ref.weight = std::bit_cast<float>(cell);  // until it is copied
            ++counts[cell];
        }
    });

    std::vector<Range> cells(cell_count);
    std::uint32_t next = 0;
    for (std::size_t cell = 0; cell < cell_count; ++cell) {
        cells[cell].begin = next;
        cells[cell].buffer = 1;
        for (std::size_t chunk = 0; chunk < chunk_count; ++chunk) {
            std::uint32_t& place = places[chunk * cell_count + cell];
            place = std::exchange(next, next + place);
        }
        cells[cell].end = next;
        const std::uint64_t spare = to.size() - from.size();
        cells[cell].spare_above =
            static_cast<std::uint32_t>(spare * cells[cell].size() / from.size());
        next += cells[cell].spare_above;
    }

    parallel_for_chunks(from.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        std::uint32_t* place = &places[begin / chunk_size * cell_count];
        for (const PrimRef& prim_ref : from.subspan(begin, end - begin)) {
            PrimRef& moved = to[place[std::bit_cast<std::uint32_t>(prim_ref.weight)]++];
            moved = prim_ref;
            moved.weight = 1.0F;
        }
    });
    return cells;
}

void measure_cells(Cells& cells, const Kernels& kernels) {
    const Splitter splitter(cells.buffers.first(), cells.buffers.second(), {}, kernels);
    parallel_for_chunks(cells.ranges.size(), 1, [&](std::size_t at, std::size_t /*end*/) {
        Range& range = cells.ranges[at];
        const Range measured = splitter.measured(range.begin, range.end, range.buffer);
        range.box = measured.box;
        range.centroids = measured.centroids;
    });
}

}  // namespace coppice::inline v0::bvh8
