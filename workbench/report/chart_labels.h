#pragma once

#include <cstddef>
#include <vector>

namespace coppice::report {

/// A place in a plot, in pixels, y downwards.
struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

/// A point of a chart that would like its label, at its place in the plot.
struct LabelPoint {
    PlotPoint at;
    std::size_t line = 0;   ///< points in a row with the same number are joined
    double width = 0.0;     ///< of the label's text
    double priority = 0.0;  ///< greater goes first
};

/// Where a label stands relative to its point.
enum class LabelSide { none, above_right, above, right, below_left, below, left };

/// For each point the first free side for its label, or `none`: labels stay in the plot from (0, 0)
/// to `corner` and overlap neither each other nor a point or a line, as far as the plot is drawn in
/// the size that the places assume.
[[nodiscard]] std::vector<LabelSide> place_labels(const std::vector<LabelPoint>& points,
                                                  PlotPoint corner);

}  // namespace coppice::report
