// Greedy placement: points in order of priority take the first of six sides that is still free.
// Lines are kept free by small boxes strung along them. Cost: O(n * boxes) for the few dozen points
// of a chart.
#include "report/chart_labels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coppice::report {
namespace {

constexpr double text_height = 10.0;
constexpr double point_radius = 4.0;
constexpr double gap = 3.0;
constexpr double bead_distance = 5.0;
constexpr double bead_radius = 1.0;

struct Box {
    double left, top, right, bottom;

    [[nodiscard]] bool overlaps(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

Box box_around(PlotPoint center, double half_width, double half_height) {
    return {center.x - half_width, center.y - half_height, center.x + half_width,
            center.y + half_height};
}

Box label_box(const LabelPoint& point, LabelSide side) {
    const double beside = point_radius + gap + point.width / 2;
    const double over = point_radius + gap + text_height / 2;
    PlotPoint center = point.at;
    switch (side) {
        case LabelSide::above_right:
            center.x += beside - gap;
            center.y -= over - gap;
            break;
        case LabelSide::above:
            center.y -= over;
            break;
        case LabelSide::right:
            center.x += beside;
            break;
        case LabelSide::below_left:
            center.x -= beside - gap;
            center.y += over - gap;
            break;
        case LabelSide::below:
            center.y += over;
            break;
        case LabelSide::left:
            center.x -= beside;
            break;
        case LabelSide::none:
            break;
    }
    return box_around(center, point.width / 2, text_height / 2);
}

std::vector<Box> boxes_of_marks(const std::vector<LabelPoint>& points) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PlotPoint from = points[i].at;
        boxes.push_back(box_around(from, point_radius, point_radius));
        if (i + 1 == points.size() || points[i + 1].line != points[i].line) continue;
        const PlotPoint to = points[i + 1].at;
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        const int bead_count = static_cast<int>(length / bead_distance);
        for (int bead = 1; bead < bead_count; ++bead) {
            const double t = static_cast<double>(bead) / bead_count;
            boxes.push_back(box_around({std::lerp(from.x, to.x, t), std::lerp(from.y, to.y, t)},
                                       bead_radius, bead_radius));
        }
    }
    return boxes;
}

}  // namespace

std::vector<LabelSide> place_labels(const std::vector<LabelPoint>& points, PlotPoint corner) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return points[a].priority > points[b].priority;
    });

    std::vector<Box> taken = boxes_of_marks(points);
    const auto is_free = [&](const Box& box) {
        return box.left >= 0.0 && box.top >= 0.0 && box.right <= corner.x &&
               box.bottom <= corner.y &&
               std::ranges::none_of(taken, [&](const Box& other) { return other.overlaps(box); });
    };
    std::vector<LabelSide> sides(points.size(), LabelSide::none);
    for (const std::size_t i : order) {
        for (const LabelSide side : {LabelSide::above_right, LabelSide::above, LabelSide::right,
                                     LabelSide::below_left, LabelSide::below, LabelSide::left}) {
            const Box box = label_box(points[i], side);
            if (!is_free(box)) continue;
            taken.push_back(box);
            sides[i] = side;
            break;
        }
    }
    return sides;
}

}  // namespace coppice::report
