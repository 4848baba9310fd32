// When a better tree has paid for its longer build. Time to image is a line over the number of
// rays; the fastest tree for each number is the lower envelope of the lines. It is walked from 0
// rays: from the line that is lowest there, to the one of smaller slope that crosses it first, and
// so on. O(n^2) for n trees, of which there are a dozen.

#include "statistics/break_even.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coppice::lab {

namespace {

/// The tree that is fastest at 0 rays, and of those the one that stays so.
std::size_t first_best(std::span<const TimeToImage> trees) {
    const auto is_better = [](const TimeToImage& a, const TimeToImage& b) {
        return a.build != b.build ? a.build < b.build : a.ray < b.ray;
    };
    return static_cast<std::size_t>(std::min_element(trees.begin(), trees.end(), is_better) -
                                    trees.begin());
}

/// The tree that overtakes another first, and where; the tree itself if none does.
BestSpan next_best(std::span<const TimeToImage> trees, std::size_t current) {
    BestSpan next{current, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < trees.size(); ++i) {
        if (!(trees[i].ray < trees[current].ray)) continue;
        const double at = break_even(trees[current], trees[i]).value_or(0.0);
        const bool is_sooner =
            at < next.from || (at == next.from && trees[i].ray < trees[next.index].ray);
        if (is_sooner) next = {i, at};
    }
    return next;
}

}  // namespace

std::optional<double> break_even(const TimeToImage& a, const TimeToImage& b) noexcept {
    const double build = a.build - b.build;
    const double ray = b.ray - a.ray;
    const bool is_trade = (build > 0.0 && ray > 0.0) || (build < 0.0 && ray < 0.0);
    if (!is_trade) return std::nullopt;
    return build / ray;
}

std::string span_text(const BestSpan& span) {
    const bool has_end = std::isfinite(span.to);
    if (span.from == 0.0 && !has_end) return "for any number of rays";
    if (span.from == 0.0) return fmt::format("up to {:.3g} rays", span.to);
    if (!has_end) return fmt::format("from {:.3g} rays", span.from);
    return fmt::format("from {:.3g} to {:.3g} rays", span.from, span.to);
}

std::vector<BestSpan> best_spans(std::span<const TimeToImage> trees) {
    std::vector<BestSpan> spans;
    if (trees.empty()) return spans;
    spans.push_back({first_best(trees)});
    while (true) {
        const BestSpan next = next_best(trees, spans.back().index);
        if (next.index == spans.back().index) return spans;
        spans.back().to = next.from;
        spans.push_back(next);
    }
}

const BestSpan& span_at(std::span<const BestSpan> spans, double ray_count) noexcept {
    const auto at = std::find_if(spans.begin(), spans.end(),
                                 [&](const BestSpan& span) { return ray_count < span.to; });
    return at == spans.end() ? spans.back() : *at;
}

}  // namespace coppice::lab
