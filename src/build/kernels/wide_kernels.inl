// The inner loops of the wide builder on eight lanes: included once for each instruction set, in a
// namespace of its own, after that set's lanes_*.inl. No fused operations, so that all sets give
// the same results.

inline const float* lanes_of(const Reference& reference) noexcept {
    return reference.negated_lower.data();
}

void unite(std::span<const Reference> references, Box8& box, Box8& centroids) noexcept {
    Lanes united = load(box.lane.data());
    Lanes centroid_range = load(centroids.lane.data());
    for (const Reference& reference : references) {
        const Lanes lanes = load(lanes_of(reference));
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

void bin(std::span<const Reference> references, const BinMapping& mapping, Bins& bins) noexcept {
    const Binner bin_of(mapping);
    for (const Reference& reference : references) {
        const Lanes lanes = load(lanes_of(reference));
        const BinLanes at = bin_of(lanes);
        add_to_bin(bins, 0, at.index[0], lanes, reference.weight);
        add_to_bin(bins, 1, at.index[1], lanes, reference.weight);
        add_to_bin(bins, 2, at.index[2], lanes, reference.weight);
    }
}

inline float block_count(float weight, const SplitCosts& costs) noexcept {
    if (!costs.whole_blocks) return weight / costs.block_size;
    const float blocks = (weight + (costs.block_size - 1.0F)) / costs.block_size;
    return static_cast<float>(static_cast<std::uint32_t>(blocks));
}

ObjectSplit find_split(const Bins& bins, std::uint32_t bin_count,
                       const SplitCosts& costs) noexcept {
    ObjectSplit best;
    const Box8 empty = Box8::make_empty();
    std::array<float, max_bin_count> upper_cost;
    std::array<float, max_bin_count> upper_weight;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const auto& boxes = bins.box[axis];
        const auto& weights = bins.weight[axis];
        Lanes box = load(empty.lane.data());
        float weight = 0.0F;
        for (std::uint32_t at = bin_count - 1; at > 0; --at) {
            box = max(load(boxes[at].lane.data()), box);
            weight += weights[at];
            upper_weight[at] = weight;
            upper_cost[at] = half_area(box, costs.extent_factor) * block_count(weight, costs);
        }
        box = load(empty.lane.data());
        weight = 0.0F;
        for (std::uint32_t at = 1; at < bin_count; ++at) {
            box = max(load(boxes[at - 1].lane.data()), box);
            weight += weights[at - 1];
            const float cost =
                half_area(box, costs.extent_factor) * block_count(weight, costs) + upper_cost[at];
            if (cost < best.cost && weight > 0.0F && upper_weight[at] > 0.0F) {
                best.cost = cost;
                best.axis = axis;
                best.bin = at;
                best.lower_weight = weight;
            }
        }
    }
    if (best.bin == 0) return best;
    Lanes lower = load(empty.lane.data());
    Lanes upper = lower;
    for (std::uint32_t at = 0; at < best.bin; ++at)
        lower = max(load(bins.box[best.axis][at].lane.data()), lower);
    for (std::uint32_t at = best.bin; at < bin_count; ++at)
        upper = max(load(bins.box[best.axis][at].lane.data()), upper);
    store(lower, best.lower_box.lane.data());
    store(upper, best.upper_box.lane.data());
    return best;
}

void partition(std::span<const Reference> references, const BinMapping& mapping,
               std::uint32_t axis, std::uint32_t bin, Reference* lower, Reference* upper,
               Box8& lower_centroids, Box8& upper_centroids) noexcept {
    const float origin = mapping.origin[axis];
    const float scale = mapping.scale[axis];
    const auto last_bin = static_cast<float>(mapping.bin_count - 1);
    std::array<Reference*, 2> out{lower, upper};
    std::array<Box8, 2> centroids{lower_centroids, upper_centroids};
    for (const Reference& reference : references) {
        const Lanes lanes = load(lanes_of(reference));
        const float sum = reference.upper[axis] - reference.negated_lower[axis];
        const float place = (sum - origin) * scale;
        const std::size_t side = bin_at(place, last_bin) >= bin ? 1 : 0;
        store(lanes, out[side]->negated_lower.data());
        ++out[side];
        float* range = centroids[side].lane.data();
        store(max(centroid_of(lanes), load(range)), range);
    }
    lower_centroids = centroids[0];
    upper_centroids = centroids[1];
}

constexpr Kernels kernels{&unite, &bin, &find_split, &partition};
