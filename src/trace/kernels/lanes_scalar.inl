// Eight lanes of floats as plain loops, for any processor. Part of a kernel source.

struct Lanes {
    std::array<float, 8> lane;
};

template <typename Operation>
inline Lanes each(Lanes a, Lanes b, Operation&& operation) noexcept {
    for (std::size_t i = 0; i < 8; ++i) {
        a.lane[i] = operation(a.lane[i], b.lane[i]);
    }
    return a;
}

inline Lanes load(const std::array<float, 8>& from) noexcept {
    return {from};
}

inline void store(Lanes lanes, std::array<float, 8>& to) noexcept {
    to = lanes.lane;
}

inline Lanes broadcast(float value) noexcept {
    return {{value, value, value, value, value, value, value, value}};
}

inline Lanes operator+(Lanes a, Lanes b) noexcept {
    return each(a, b, [](float x, float y) { return x + y; });
}

inline Lanes operator-(Lanes a, Lanes b) noexcept {
    return each(a, b, [](float x, float y) { return x - y; });
}

inline Lanes operator*(Lanes a, Lanes b) noexcept {
    return each(a, b, [](float x, float y) { return x * y; });
}

inline Lanes operator/(Lanes a, Lanes b) noexcept {
    return each(a, b, [](float x, float y) { return x / y; });
}

// a * b - c, rounded once or twice.
inline Lanes multiply_subtract(Lanes a, Lanes b, Lanes c) noexcept {
    return a * b - c;
}

// a - b * c, rounded once or twice.
inline Lanes subtract_product(Lanes a, Lanes b, Lanes c) noexcept {
    return a - b * c;
}

// The second argument where the first is NaN.
inline Lanes min(Lanes a, Lanes b) noexcept {
    return each(a, b, [](float x, float y) { return x < y ? x : y; });
}

inline Lanes max(Lanes a, Lanes b) noexcept {
    return each(a, b, [](float x, float y) { return x > y ? x : y; });
}

inline Lanes abs(Lanes a) noexcept {
    return each(a, a, [](float x, float /*same*/) { return std::abs(x); });
}

// The larger of two without their signs.
inline Lanes larger_size(Lanes a, Lanes b) noexcept {
    return max(abs(a), abs(b));
}

// A bit for every lane in which a <= b.
inline unsigned less_equal(Lanes a, Lanes b) noexcept {
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i) {
        mask |= (a.lane[i] <= b.lane[i] ? 1U : 0U) << i;
    }
    return mask;
}

// The same for a < b.
inline unsigned less(Lanes a, Lanes b) noexcept {
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i) {
        mask |= (a.lane[i] < b.lane[i] ? 1U : 0U) << i;
    }
    return mask;
}

// What is faster as integers in a register is not here.
inline Lanes bits_max(Lanes a, Lanes b) noexcept {
    return max(a, b);
}

inline Lanes bits_min(Lanes a, Lanes b) noexcept {
    return min(a, b);
}

inline unsigned bits_less_equal(Lanes a, Lanes b) noexcept {
    return less_equal(a, b);
}
