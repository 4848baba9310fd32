// The three protocols are a controlled experiment: they share the sample and so the upper planes.
// `fixed` stops early and `scaled` does not: their difference is what stopping early costs. Both
// leave the leaves as the sample made them and `grown` does not: what is left of its excess, but
// for duplicates, is what the planes cost that were kept. Tests in cells that only the sample knew
// as empty, and of duplicated references, are counted in the tree itself.

#include "rows/cost_decomposition.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::lab {

namespace {

/// The cost of a tree, and what of it is due to two causes that can be seen in the tree.
struct SeenCosts {
    double cost = 0.0;
    double empty_cells = 0.0;
    double duplicates = 0.0;

    [[nodiscard]] double without_duplicates() const { return cost - duplicates; }
};

SeenCosts seen_costs(const ResultRow& row) {
    const TreeStatistics& statistics = row.report.statistics;
    const double test = cost_of(row.report.options).intersection;
    SeenCosts seen{statistics.sah_cost, test * row.unsampled_tests, 0.0};
    const auto references = static_cast<double>(statistics.reference_count);
    if (!(references > 0.0)) return seen;
    const double repeated = std::max(0.0, 1.0 - row.report.primitive_count / references);
    const double other_tests = statistics.expected_primitive_tests - row.unsampled_tests;
    seen.duplicates = test * repeated * other_tests;
    return seen;
}

/// The trees of one kind, sampler and seed at a percentage and at 100, by protocol.
class Trees {
public:
    Trees(std::span<const ResultRow> rows, const ResultRow& like) : rows_(rows), like_(like) {}

    [[nodiscard]] const ResultRow* sampled(std::string_view protocol) const {
        return find(protocol, like_.sample_percent);
    }

    [[nodiscard]] const ResultRow* full(std::string_view protocol) const {
        return find(protocol, 100.0);
    }

private:
    [[nodiscard]] const ResultRow* find(std::string_view protocol, double percent) const {
        const TreeSeries series{like_.primitives, std::string(protocol), like_.sampler};
        const auto at = std::find_if(rows_.begin(), rows_.end(), [&](const ResultRow& row) {
            return row.series() == series && row.sample_percent == percent &&
                   row.seed == like_.seed;
        });
        return at == rows_.end() ? nullptr : &*at;
    }

    std::span<const ResultRow> rows_;
    const ResultRow& like_;
};

/// The parts in the unit of the costs. `row` is one of the three sampled trees, all of which are
/// there, but `scaled` and `fixed` need not be if it is `grown` itself.
void find_parts(const Trees& trees, CostParts& parts) {
    const SeenCosts grown = seen_costs(*trees.sampled("grown"));
    const SeenCosts full_grown = seen_costs(*trees.full("grown"));
    parts.plane_error = grown.without_duplicates() - full_grown.without_duplicates();
    if (parts.protocol == "grown") {
        parts.duplicates = grown.duplicates - full_grown.duplicates;
        return;
    }
    const SeenCosts scaled = seen_costs(*trees.sampled("scaled"));
    parts.duplicates = scaled.duplicates - seen_costs(*trees.full("scaled")).duplicates;
    parts.empty_cells = scaled.empty_cells;
    if (parts.protocol == "fixed") {
        parts.early_stop = seen_costs(*trees.sampled("fixed")).cost - scaled.cost;
    }
}

bool has_all(const Trees& trees, const std::string& protocol) {
    constexpr std::array needed{"grown", "scaled", "fixed"};
    const std::size_t count = protocol == "grown" ? 1 : protocol == "scaled" ? 2 : 3;
    return std::all_of(needed.begin(), needed.begin() + count, [&](const char* name) {
        return trees.sampled(name) != nullptr && trees.full(name) != nullptr;
    });
}

}  // namespace

std::vector<CostParts> decompose_costs(std::span<const ResultRow> rows) {
    std::vector<CostParts> decomposed;
    for (const ResultRow& row : rows) {
        const bool is_known =
            row.protocol == "fixed" || row.protocol == "scaled" || row.protocol == "grown";
        const Trees trees(rows, row);
        if (!is_known || row.sample_percent == 100.0 || !has_all(trees, row.protocol)) continue;
        const double full = trees.full(row.protocol)->report.statistics.sah_cost;
        if (!(full > 0.0) || !std::isfinite(row.report.statistics.sah_cost)) continue;
        CostParts parts{row};
        find_parts(trees, parts);
        parts.excess = row.report.statistics.sah_cost / full - 1.0;
        for (double* part :
             {&parts.early_stop, &parts.empty_cells, &parts.duplicates, &parts.plane_error}) {
            *part /= full;
        }
        parts.uneven_leaves = parts.excess - parts.early_stop - parts.empty_cells -
                              parts.duplicates - parts.plane_error;
        decomposed.push_back(parts);
    }
    return decomposed;
}

}  // namespace coppice::lab
