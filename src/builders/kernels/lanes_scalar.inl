// Eight lanes as plain loops: what the kernels need, for any processor. Part of a kernel source.

struct Lanes {
    Box8 value;
};

inline Lanes load(const float* from) noexcept {
    Lanes lanes;
    std::copy_n(from, 8, lanes.value.lane.begin());
    return lanes;
}

inline void store(Lanes lanes, float* to) noexcept {
    std::copy_n(lanes.value.lane.begin(), 8, to);
}

inline Lanes max(Lanes a, Lanes b) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        a.value.lane[i] = a.value.lane[i] > b.value.lane[i] ? a.value.lane[i] : b.value.lane[i];
    }
    return a;
}

inline Lanes min(Lanes a, Lanes b) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        a.value.lane[i] = a.value.lane[i] < b.value.lane[i] ? a.value.lane[i] : b.value.lane[i];
    }
    return a;
}

inline Lanes operator+(Lanes a, Lanes b) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        a.value.lane[i] += b.value.lane[i];
    }
    return a;
}

inline Lanes operator-(Lanes a, Lanes b) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        a.value.lane[i] -= b.value.lane[i];
    }
    return a;
}

inline Lanes operator*(Lanes a, Lanes b) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        a.value.lane[i] *= b.value.lane[i];
    }
    return a;
}

inline Lanes broadcast(float value) noexcept {
    return {{{value, value, value, value, value, value, value, value}}};
}

// Lanes 4 to 7 before lanes 0 to 3.
inline Lanes swap_halves(Lanes lanes) noexcept {
    std::rotate(lanes.value.lane.begin(), lanes.value.lane.begin() + 4, lanes.value.lane.end());
    return lanes;
}

inline Lanes with_lane(Lanes lanes, std::size_t lane, float value) noexcept {
    lanes.value.lane[lane] = value;
    return lanes;
}

// Whether a box is not empty on any axis.
inline bool has_extent(const Lanes& box) noexcept {
    bool has = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        has &= box.value.lane[axis] + box.value.lane[4 + axis] >= 0.0F;
    }
    return has;
}

// A point: its coordinates negated, and as they are.
inline Lanes lanes_of(const Vec3f& point) noexcept {
    return {{{-point.x, -point.y, -point.z, -0.0F, point.x, point.y, point.z, 0.0F}}};
}

// The lanes, or -infinity in all of them.
inline Lanes only_if(bool condition, Lanes lanes) noexcept {
    return condition ? lanes : Lanes{Box8::make_empty()};
}

// The sums lower + upper, negated in lanes 0 to 2, as they are in lanes 4 to 6.
inline Lanes centroid_of(Lanes prim_ref) noexcept {
    Lanes centroid;
    for (std::size_t i = 0; i < 4; ++i) {
        const float sum = prim_ref.value.lane[4 + i] - prim_ref.value.lane[i];
        centroid.value.lane[i] = -sum;
        centroid.value.lane[4 + i] = sum;
    }
    return centroid;
}

struct BinLanes {
    std::array<std::uint32_t, 3> index;
};

class Binner {
public:
    explicit Binner(const BinMapping& mapping) noexcept : mapping_(mapping) {}

    [[nodiscard]] BinLanes operator()(Lanes prim_ref) const noexcept {
        BinLanes bins{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float sum = prim_ref.value.lane[4 + axis] - prim_ref.value.lane[axis];
            const float place = (sum - mapping_.origin[axis]) * mapping_.scale[axis];
            bins.index[axis] = bin_at(place, static_cast<float>(mapping_.bin_count - 1));
        }
        return bins;
    }

private:
    const BinMapping& mapping_;
};

// Half the surface area of a box, its edges scaled.
inline float half_area(Lanes box, float factor) noexcept {
    const float x = (box.value.lane[4] + box.value.lane[0]) * factor;
    const float y = (box.value.lane[5] + box.value.lane[1]) * factor;
    const float z = (box.value.lane[6] + box.value.lane[2]) * factor;
    return x * y + y * z + z * x;
}

// The coordinates of eight points, axis by axis.
inline void transpose(const std::array<const Vec3f*, 8>& points,
                      std::array<std::array<float, 8>, 3>& axes) noexcept {
    for (std::size_t lane = 0; lane < 8; ++lane) {
        axes[0][lane] = points[lane]->x;
        axes[1][lane] = points[lane]->y;
        axes[2][lane] = points[lane]->z;
    }
}
