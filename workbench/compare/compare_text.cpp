#include "compare/compare.h"
#include "text/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* compare_line = "{:<7} {:<48} {:<24} {:>12} {:>12} {:>8}  {}\n";

std::string interval_text(const Difference& difference) {
    if (!difference.interval) return "-";
    return fmt::format("[{:.4f}, {:.4f}]", difference.interval->low, difference.interval->high);
}

std::string line_of(const Difference& difference) {
    return fmt::format(compare_line, difference.is_worse ? "worse" : "better", difference.row,
                       difference.measure, fmt::format("{:.6g}", difference.before),
                       fmt::format("{:.6g}", difference.after),
                       fmt::format("{:.4f}", difference.ratio), interval_text(difference));
}

std::string rule_text(const CompareOptions& options) {
    return fmt::format(
        "with several seeds in common a figure differs if 1 is outside the {} of the mean of B/A, "
        "paired by seed, and times and speeds besides by more than {:.3g} %; else costs, steps and "
        "bytes differ by more than {:.3g} %, times and speeds by more than {:.3g} %; build times "
        "by more than 2 ms; of mismatches one more is worse",
        interval_name, 100.0 * options.time_tolerance, 100.0 * options.tolerance,
        100.0 * options.time_tolerance);
}

Json difference_json(const Difference& difference) {
    Json json{{"row", difference.row},
              {"measure", difference.measure},
              {"verdict", difference.is_worse ? "worse" : "better"},
              {"a", number_json(difference.before)},
              {"b", number_json(difference.after)},
              {"ratio", number_json(difference.ratio)},
              {"interval", nullptr}};
    if (difference.interval) {
        json["interval"] = {difference.interval->low, difference.interval->high};
    }
    return json;
}

}  // namespace

std::string comparison_text(const Comparison& comparison, const CompareOptions& options) {
    std::string text =
        fmt::format("{} rows are in both, {} only in A, {} only in B\n", comparison.row_count,
                    comparison.only_before.size(), comparison.only_after.size());
    for (const std::string& row : comparison.only_before) {
        text += fmt::format("only in A: {}\n", row);
    }
    for (const std::string& row : comparison.only_after) {
        text += fmt::format("only in B: {}\n", row);
    }
    for (const std::string& note : comparison.notes) {
        text += fmt::format("note: {}\n", note);
    }
    text += fmt::format("rule: {}\n\n", rule_text(options));
    if (!comparison.differences.empty()) {
        text += fmt::format(compare_line, "", "row", "figure", "A", "B", "B/A", "95 % of B/A");
    }
    for (const Difference& difference : comparison.differences) {
        text += line_of(difference);
    }
    const std::size_t worse_count = comparison.worse_count();
    const std::size_t better_count = comparison.differences.size() - worse_count;
    return text + fmt::format("{} figures compared: {} worse, {} better in B, {} within noise\n",
                              comparison.figure_count, worse_count, better_count,
                              comparison.figure_count - comparison.differences.size());
}

Json comparison_json(const Comparison& comparison, const CompareOptions& options) {
    Json json{{"rule", rule_text(options)},
              {"tolerance", options.tolerance},
              {"time_tolerance", options.time_tolerance},
              {"rows", comparison.row_count},
              {"figures", comparison.figure_count},
              {"worse", comparison.worse_count()},
              {"better", comparison.differences.size() - comparison.worse_count()},
              {"only_in_a", comparison.only_before},
              {"only_in_b", comparison.only_after},
              {"notes", comparison.notes},
              {"differences", Json::array()}};
    for (const Difference& difference : comparison.differences) {
        json["differences"].push_back(difference_json(difference));
    }
    return json;
}

}  // namespace coppice::lab
