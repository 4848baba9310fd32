// The inner loops of the 8-wide builder on eight lanes: included once for each instruction set, in
// a namespace of its own, after that set's lanes_*.inl. No fused operations, so that all sets give
// the same results.

inline const float* lanes_of(const PrimRef& prim_ref) noexcept {
    return prim_ref.negated_lower.data();
}

void unite(std::span<const PrimRef> prim_refs, Box8& box, Box8& centroids) noexcept {
    Lanes united = load(box.lane.data());
    Lanes centroid_range = load(centroids.lane.data());
    for (const PrimRef& prim_ref : prim_refs) {
        const Lanes lanes = load(lanes_of(prim_ref));
        united = max(lanes, united);
        centroid_range = max(centroid_of(lanes), centroid_range);
    }
    store(united, box.lane.data());
    store(centroid_range, centroids.lane.data());
}

inline void add_to_bin(Bins& bins, std::size_t axis, std::uint32_t bin, Lanes lanes,
                       float weight) noexcept {
    float* box = bins.box[axis][bin].lane.data();
    store(max(lanes, load(box)), box);
    bins.weight[axis][bin] += weight;
}

inline void add(Bins& bins, const Binner& bin_of, const PrimRef& prim_ref) noexcept {
    const Lanes lanes = load(lanes_of(prim_ref));
    const BinLanes at = bin_of(lanes);
    add_to_bin(bins, 0, at.index[0], lanes, prim_ref.weight);
    add_to_bin(bins, 1, at.index[1], lanes, prim_ref.weight);
    add_to_bin(bins, 2, at.index[2], lanes, prim_ref.weight);
}

// Neighbours in the mesh fall into the same bin, and each would wait for the one before to be
// stored. Two sets of bins in turn halve that wait; merging them pays from here on.
constexpr std::size_t min_two_sets = 128;

void bin(std::span<const PrimRef> prim_refs, const BinMapping& mapping, Bins& bins) noexcept {
    const Binner bin_of(mapping);
    if (prim_refs.size() < min_two_sets) {
        for (const PrimRef& prim_ref : prim_refs) {
            add(bins, bin_of, prim_ref);
        }
        return;
    }
    Bins others;
    clear(others, mapping.bin_count);
    const std::size_t even = prim_refs.size() / 2 * 2;
    for (std::size_t at = 0; at < even; at += 2) {
        add(bins, bin_of, prim_refs[at]);
        add(others, bin_of, prim_refs[at + 1]);
    }
    if (even < prim_refs.size()) add(bins, bin_of, prim_refs[even]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t at = 0; at < mapping.bin_count; ++at) {
            add_to_bin(bins, axis, at, load(others.box[axis][at].lane.data()),
                       others.weight[axis][at]);
        }
    }
}

using PerBin = std::array<float, max_bin_count>;

// Of the bins before (or from) each border: half the area of their box, and their weight.
struct Side {
    alignas(32) PerBin area;
    alignas(32) PerBin weight;
};

// Border `at` is between bins at - 1 and at.
inline void sum_below(const std::array<Box8, max_bin_count>& boxes, const PerBin& weights,
                      std::uint32_t bin_count, float factor, Side& below) noexcept {
    Lanes box = load(boxes[0].lane.data());
    float weight = weights[0];
    for (std::uint32_t at = 1; at < bin_count; ++at) {
        below.area[at] = half_area(box, factor);
        below.weight[at] = weight;
        box = max(load(boxes[at].lane.data()), box);
        weight += weights[at];
    }
}

inline void sum_above(const std::array<Box8, max_bin_count>& boxes, const PerBin& weights,
                      std::uint32_t bin_count, float factor, Side& above) noexcept {
    Lanes box = load(boxes[bin_count - 1].lane.data());
    float weight = weights[bin_count - 1];
    for (std::uint32_t at = bin_count - 1; at > 0; --at) {
        above.area[at] = half_area(box, factor);
        above.weight[at] = weight;
        box = max(load(boxes[at - 1].lane.data()), box);
        weight += weights[at - 1];
    }
}

// The cost of every border; infinite where a side has nothing.
inline void cost_borders(const Side& below, const Side& above, const SplitCosts& costs,
                         PerBin& cost) noexcept {
    const float round_up = costs.whole_blocks ? costs.block_size - 1.0F : 0.0F;
    const float per_block = 1.0F / costs.block_size;
    for (std::size_t at = 0; at < max_bin_count; ++at) {
        float blocks_below = (below.weight[at] + round_up) * per_block;
        float blocks_above = (above.weight[at] + round_up) * per_block;
        if (costs.whole_blocks) {
            blocks_below = static_cast<float>(static_cast<std::int32_t>(blocks_below));
            blocks_above = static_cast<float>(static_cast<std::int32_t>(blocks_above));
        }
        const float both = below.area[at] * blocks_below + above.area[at] * blocks_above;
        const bool is_split = (below.weight[at] > 0.0F) & (above.weight[at] > 0.0F);
        cost[at] = is_split ? both : std::numeric_limits<float>::infinity();
    }
}

void unite_sides(const std::array<Box8, max_bin_count>& boxes, std::uint32_t bin_count,
                 ObjectSplit& split) noexcept {
    Lanes lower = load(boxes[0].lane.data());
    Lanes upper = load(boxes[split.bin].lane.data());
    for (std::uint32_t at = 1; at < split.bin; ++at) {
        lower = max(load(boxes[at].lane.data()), lower);
    }
    for (std::uint32_t at = split.bin + 1; at < bin_count; ++at) {
        upper = max(load(boxes[at].lane.data()), upper);
    }
    store(lower, split.lower_box.lane.data());
    store(upper, split.upper_box.lane.data());
}

// The bins of one axis.
struct BinnedAxis {
    std::uint32_t axis;
    const std::array<Box8, max_bin_count>& boxes;
    const PerBin& weights;
    std::uint32_t bin_count;
};

// Takes the cheapest border on an axis if it is cheaper than the best so far.
inline void improve_split(const BinnedAxis& bins, const SplitCosts& costs,
                          ObjectSplit& best) noexcept {
    Side below{};
    Side above{};
    alignas(32) PerBin cost;
    sum_below(bins.boxes, bins.weights, bins.bin_count, costs.extent_factor, below);
    sum_above(bins.boxes, bins.weights, bins.bin_count, costs.extent_factor, above);
    cost_borders(below, above, costs, cost);
    const auto least = std::min_element(cost.begin() + 1, cost.begin() + bins.bin_count);
    if (!(*least < best.cost)) return;
    best.cost = *least;
    best.axis = bins.axis;
    best.bin = static_cast<std::uint32_t>(least - cost.begin());
    best.lower_weight = below.weight[best.bin];
}

ObjectSplit find_split(const Bins& bins, std::uint32_t bin_count,
                       const SplitCosts& costs) noexcept {
    ObjectSplit best;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        improve_split({axis, bins.box[axis], bins.weight[axis], bin_count}, costs, best);
    }
    if (best.bin != 0) unite_sides(bins.box[best.axis], bin_count, best);
    return best;
}

void partition(std::span<const PrimRef> prim_refs, const Border& border, Sides<PrimRef*> out,
               Sides<Box8>& centroids) noexcept {
    std::array<PrimRef*, 2> next{out.lower, out.upper};
    Lanes lower_range = load(centroids.lower.lane.data());
    Lanes upper_range = load(centroids.upper.lane.data());
    for (const PrimRef& prim_ref : prim_refs) {
        const Lanes lanes = load(lanes_of(prim_ref));
        const bool is_upper = border.mapping.bin_of(prim_ref, border.axis) >= border.bin;
        const std::size_t side = is_upper ? 1 : 0;
        store(lanes, next[side]->negated_lower.data());
        ++next[side];
        const Lanes centroid = centroid_of(lanes);
        lower_range = max(only_if(side == 0, centroid), lower_range);
        upper_range = max(only_if(side != 0, centroid), upper_range);
    }
    store(lower_range, centroids.lower.lane.data());
    store(upper_range, centroids.upper.lane.data());
}

void fill_block(std::span<const std::uint32_t> ids, const MeshArrays& mesh,
                TriangleBlock& block) noexcept {
    std::array<const Vec3f*, 8> corner;
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            corner[lane] =
                lane < ids.size() ? &mesh.vertices[mesh.triangles[ids[lane]][vertex]] : &nowhere;
        }
        transpose(corner, block.corner[vertex]);
    }
    for (std::size_t lane = 0; lane < 8; ++lane) {
        block.id[lane] = lane < ids.size() ? ids[lane] : TriangleBlock::no_triangle;
    }
}

#include "builders/kernels/spatial_kernels.inl"

constexpr Kernels kernels{&unite,      &bin,          &find_split,   &partition,
                          &bin_pieces, &count_pieces, &write_pieces, &fill_block};
