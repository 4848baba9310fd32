#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coppice::lab {

/// What an image costs with a tree: `build` once and `ray` for each ray, both in seconds, finite
/// and >= 0.
struct TimeToImage {
    double build = 0.0;
    double ray = 0.0;

    [[nodiscard]] double seconds(double ray_count) const noexcept {
        return build + ray_count * ray;
    }
};

/// After how many rays a tree with the longer build has caught up with the other:
/// N* = (build_a - build_b) / (ray_b - ray_a), the same for (a, b) and (b, a). Nothing if it never
/// does: one of them is not slower in either, or both are equal.
[[nodiscard]] std::optional<double> break_even(const TimeToImage& a, const TimeToImage& b) noexcept;

/// A tree that is the fastest from `from` to `to` rays.
struct BestSpan {
    std::size_t index = 0;  ///< of the tree
    double from = 0.0;
    double to = std::numeric_limits<double>::infinity();
};

/// "up to 2e+06 rays", "from 1e+05 to 2e+06 rays", "for any number of rays".
[[nodiscard]] std::string span_text(const BestSpan& span);

/// Which of the trees is the fastest for which number of rays: spans that follow one another from
/// 0 to infinity. Of equal trees the first is taken. Empty if there are no trees.
[[nodiscard]] std::vector<BestSpan> best_spans(std::span<const TimeToImage> trees);

/// The span that a number of rays, >= 0, lies in; one on the border belongs to the later span.
[[nodiscard]] const BestSpan& span_at(std::span<const BestSpan> spans, double ray_count) noexcept;

}  // namespace coppice::lab
