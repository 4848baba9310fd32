// The top of a wide tree from a sample: a binary tree of object splits over the sampled references,
// each counting 1/p primitives in the costs, and the pass that sends all references down it. A cell
// takes what has its centroid there, so nothing is cut and boxes grow to fit. The descent branches:
// meshes are coherent, and branches that repeat cost less than the arithmetic that avoids them.
// Cost: sample size times its depth, then N times the depth of the top.
// Source: [Tessari2023] sec. 3, [Wald2007] sec. 3.

#include "build/wide/top.h"

#include "coppice/base/parallel.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace coppice::wide {
namespace {

// Fewer sampled references do not tell where to split.
constexpr std::uint32_t min_sampled = 8;

float weight_of(std::span<const Reference> references) {
    float sum = 0.0F;
    for (const Reference& reference : references)
        sum += reference.weight;
    return sum;
}

class TopBuilder {
public:
    TopBuilder(const Splitter& splitter, float cell_size)
        : splitter_(splitter), cell_size_(cell_size) {}

    void build(std::uint32_t slot, const Range& range) {
        BinMapping mapping{};
        const bool is_small = range.size() < 2 * min_sampled ||
                              weight_of(splitter_.references(range)) <= cell_size_;
        const ObjectSplit split = is_small ? ObjectSplit{} : splitter_.find(range, mapping);
        if (split.bin == 0) {
            top_.nodes[slot].index = cell_count_++;
            return;
        }
        const Halves halves = splitter_.divide(range, split, mapping);
        const auto lower = static_cast<std::uint32_t>(top_.nodes.size());
        top_.nodes[slot] = {split.axis, mapping.begin_of(split.axis, split.bin), lower};
        top_.nodes.resize(lower + 2);
        build(lower, halves.lower);
        build(lower + 1, halves.upper);
    }

    [[nodiscard]] Top take() && {
        top_.cell_count = cell_count_;
        return std::move(top_);
    }

private:
    const Splitter& splitter_;
    float cell_size_;
    Top top_;
    std::uint32_t cell_count_ = 0;
};

std::uint32_t cell_of(const Top& top, const Reference& reference) {
    const TopNode* node = top.nodes.data();
    while (node->axis != TopNode::is_cell) {
        const float sum = reference.upper[node->axis] - reference.negated_lower[node->axis];
        node = &top.nodes[node->index + (sum < node->position ? 0U : 1U)];
    }
    return node->index;
}

}  // namespace

Top build_object_top(std::span<Reference> sample, float cell_size, const Kernels& kernels) {
    std::vector<Reference> buffer(sample.size());
    Splitter measure(sample, buffer, {}, kernels);
    const Range all = measure.measured(0, static_cast<std::uint32_t>(sample.size()), 0);
    const Splitter splitter(sample, buffer, {8.0F, false, extent_factor_of(all.box)}, kernels);
    TopBuilder builder(splitter, cell_size);
    builder.build(0, all);
    return std::move(builder).take();
}

std::vector<Range> fill_cells(const Top& top, std::span<Reference> from, std::span<Reference> to) {
    // Chunks depend on the sizes alone; as many as keep two threads busy and their counts small.
    const std::size_t chunk_size = std::max<std::size_t>(16384, from.size() / 64);
    const std::size_t chunk_count = (from.size() + chunk_size - 1) / chunk_size;
    const std::size_t cell_count = top.cell_count;
    std::vector<std::uint32_t> places(chunk_count * cell_count);  // [chunk][cell]

    parallel_for_chunks(from.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        std::uint32_t* counts = &places[begin / chunk_size * cell_count];
        for (Reference& reference : from.subspan(begin, end - begin)) {
            const std::uint32_t cell = cell_of(top, reference);
            reference.weight = std::bit_cast<float>(cell);  // until it is moved
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
    }

    parallel_for_chunks(from.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        std::uint32_t* place = &places[begin / chunk_size * cell_count];
        for (const Reference& reference : from.subspan(begin, end - begin)) {
            Reference& moved = to[place[std::bit_cast<std::uint32_t>(reference.weight)]++];
            moved = reference;
            moved.weight = 1.0F;
        }
    });
    return cells;
}

}  // namespace coppice::wide
