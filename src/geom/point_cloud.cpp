#include "coppice/geom/point_cloud.h"

#include "coppice/base/rng.h"

#include "geom/require_ids.h"

#include <algorithm>
#include <tuple>

namespace coppice::inline v0 {
namespace {

void remove_duplicates(std::vector<Vec3f>& points) {
    std::sort(points.begin(), points.end(), [](const Vec3f& a, const Vec3f& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

// A Fisher-Yates shuffle with counter-based random numbers.
void shuffle(std::vector<Vec3f>& points, std::uint64_t seed) {
    for (std::size_t i = points.size(); i > 1; --i) {
        const auto other = static_cast<std::size_t>(random_unit(seed, i) * static_cast<double>(i));
        std::swap(points[i - 1], points[other]);
    }
}

}  // namespace

PointCloudView::PointCloudView(std::span<const Vec3f> points) : points_(points) {
    require_ids(points.size(), "points");
}

std::vector<Vec3f> shuffled_distinct_points(std::span<const Vec3f> points, std::uint64_t seed) {
    std::vector<Vec3f> distinct(points.begin(), points.end());
    // Turns -0 into +0: which of the two remains must not depend on the sort.
    for (Vec3f& point : distinct) {
        point = point + Vec3f{};
    }
    remove_duplicates(distinct);
    shuffle(distinct, seed);
    return distinct;
}

}  // namespace coppice::inline v0
