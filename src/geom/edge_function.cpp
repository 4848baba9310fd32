// Decides without rounding error on which side of a ray an edge passes. First, in double-double
// arithmetic, about 200 operations. Where the ray meets the edge or nearly does, that is not
// precise enough, and all terms are summed exactly as an expansion: a few hundred operations,
// 30,000 at worst.
// Source: [Shewchuk1997] sec. 2.3, 2.4 (expansions).

#include "geom/edge_function.h"

#include "geom/double_double.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace coppice::inline v0 {
namespace {

// A sum of doubles without rounding: non-overlapping components, the largest last.
class Expansion {
public:
    static constexpr std::size_t max_terms = 96;

    // Adds a term. May be called at most max_terms times.
    void add(double term) noexcept {
        std::size_t size = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const DoubleDouble sum = DoubleDouble::sum(term, parts_[i]);
            if (sum.low != 0.0) parts_[size++] = sum.low;
            term = sum.high;
        }
        if (term != 0.0) parts_[size++] = term;
        size_ = size;
    }

    // The sum, rounded to a double. The sign is exact.
    [[nodiscard]] double value() const noexcept { return size_ == 0 ? 0.0 : parts_[size_ - 1]; }

private:
    std::array<double, max_terms> parts_;
    std::size_t size_ = 0;
};

// Adds a * b * c. Most components are zero: differences of floats and products of two of them fit
// into one double, unless their magnitudes are very different.
void add_product(Expansion& sum, double a, DoubleDouble b, DoubleDouble c) noexcept {
    if (a == 0.0) return;
    for (const double b_part : {b.high, b.low}) {
        if (b_part == 0.0) break;
        for (const double c_part : {c.high, c.low}) {
            if (c_part == 0.0) break;
            const DoubleDouble bc = DoubleDouble::product(b_part, c_part);
            for (const double bc_part : {bc.high, bc.low}) {
                if (bc_part == 0.0) break;
                const DoubleDouble abc = DoubleDouble::product(a, bc_part);
                sum.add(abc.high);
                sum.add(abc.low);
            }
        }
    }
}

double exact_volume(Vec3d direction, const Vec3<DoubleDouble>& start,
                    const Vec3<DoubleDouble>& edge) noexcept {
    Expansion sum;
    for (const Axis axis : all_axes) {
        const Axis second = next_axis(axis);
        const Axis third = next_axis(second);
        add_product(sum, direction[axis], start[second], edge[third]);
        add_product(sum, -direction[axis], start[third], edge[second]);
    }
    return sum.value();
}

double sum_of_abs(Vec3d v) noexcept {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

Vec3d rounded(const Vec3<DoubleDouble>& v) noexcept {
    return {v.x.high, v.y.high, v.z.high};
}

}  // namespace

double edge_function(Vec3d origin, Vec3d direction, Vec3d from, Vec3d to) noexcept {
    const Vec3<DoubleDouble> start = exact_difference(from, origin);
    const Vec3<DoubleDouble> edge = exact_difference(to, from);
    const double volume = dot(exact_difference(direction, {}), cross(start, edge)).high;
    const double terms =
        sum_of_abs(direction) * sum_of_abs(rounded(start)) * sum_of_abs(rounded(edge));
    if (std::abs(volume) > 0x1.0p-96 * terms) return volume;
    return exact_volume(direction, start, edge);
}

}  // namespace coppice::inline v0
