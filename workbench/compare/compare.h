#pragma once

#include "statistics/confidence.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coppice::lab {

/// What two results may differ by before it counts, as shares of the first.
struct CompareOptions {
    double tolerance = 0.01;       ///< of costs, steps and bytes, where there are no seeds; >= 0
    double time_tolerance = 0.25;  ///< of times and speeds; >= 0
};

/// A figure that differs beyond noise.
struct Difference {
    std::string row;      ///< "dragon, triangles, grown, 10 %"
    std::string measure;  ///< "sah_cost"
    double before = 0.0;  ///< mean of the seeds that both have
    double after = 0.0;
    double ratio = 1.0;                ///< mean of after / before over these seeds
    std::optional<Interval> interval;  ///< of the ratio, paired by seed
    bool is_worse = false;
};

/// All that two results differ in. Rows are in the order of the first.
struct Comparison {
    std::size_t row_count = 0;     ///< in both
    std::size_t figure_count = 0;  ///< compared
    std::vector<Difference> differences;
    std::vector<std::string> only_before;  ///< rows
    std::vector<std::string> only_after;
    std::vector<std::string> notes;  ///< what makes the comparison unequal: other machine, options

    [[nodiscard]] std::size_t worse_count() const;
};

/// Reads a JSON file that an experiment or a benchmark wrote; of a folder, the results.json in it.
/// Throws Error(io) or Error(parse).
[[nodiscard]] nlohmann::json load_results(const std::filesystem::path& path);

/// Compares two results of an experiment, or of a benchmark, row by row. A figure differs
/// - that has several seeds in common: if 1 is outside the 95 % t interval of the mean of the
/// ratio,
///   paired by seed; times and speeds must differ by more than their tolerance as well;
/// - else: if the ratio is further from 1 than the tolerance.
/// Build times that differ by less than 2 ms are taken as equal. Of hits, one mismatch more is
/// worse. What rays took is compared kind by kind (speed and steps), if both made the same rays.
/// Throws Error(parse) for documents that are neither, Error(invalid_argument) if one is of another
/// kind than the other, or if they have no row in common.
[[nodiscard]] Comparison compare_results(const nlohmann::json& before, const nlohmann::json& after,
                                         const CompareOptions& options);

/// The comparison as plain text, with how it judges.
[[nodiscard]] std::string comparison_text(const Comparison& comparison,
                                          const CompareOptions& options);

/// The comparison as one object.
[[nodiscard]] nlohmann::ordered_json comparison_json(const Comparison& comparison,
                                                     const CompareOptions& options);

}  // namespace coppice::lab
