#pragma once

#include "report/series.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace coppice::report {

/// How a protocol is named and drawn everywhere on the page.
struct ProtocolStyle {
    std::string name;   ///< in text: "fixed leaf limit"
    std::string label;  ///< in charts: "fixed limit"
    std::string color;  ///< of Okabe and Ito's palette, safe for colour-blind readers
    std::string shape;  ///< the Vega symbol of its points
};

/// The style of any protocol; unknown ones are called by their own name.
[[nodiscard]] ProtocolStyle protocol_style(std::string_view protocol);

/// The unit that suits times up to `greatest_seconds`.
struct TimeUnit {
    std::string name;         ///< "s", "ms" or "µs"
    double per_second = 1.0;  ///< units in a second
};

[[nodiscard]] TimeUnit time_unit(double greatest_seconds);

/// The unit that suits every time called `key` of the series.
[[nodiscard]] TimeUnit time_unit(const Series& series, std::string_view key);

/// The ends of the band (Range::band_low()) of a measure at every point, times `factor`.
[[nodiscard]] std::vector<double> collect_ends(const Series& series, std::string_view key,
                                               double factor = 1.0);

/// Whether a point of the series stands for several seeds.
[[nodiscard]] bool has_seeds(const Series& series);

/// Whether a measure of the series has intervals, so that its bands show them.
[[nodiscard]] bool has_intervals(const Series& series, std::string_view key);

/// Sets the fields `field`, and `field`_min and `field`_max to the ends of its band, times
/// `factor`.
void put_range(nlohmann::json& value, const std::string& field, const Range& range,
               double factor = 1.0);

/// The six leading digits: more than a screen shows.
[[nodiscard]] double rounded(double value);

/// The marks of every line chart.
[[nodiscard]] nlohmann::json line_mark();
[[nodiscard]] nlohmann::json point_mark(int size = 46);

/// A chart without marks yet: as wide as its place, without a request to anywhere.
[[nodiscard]] nlohmann::json chart_frame(const std::string& description, int height);

/// Colour, and shape where points are drawn, by the field `protocol` that holds the labels.
[[nodiscard]] nlohmann::json protocol_color(const std::vector<std::string>& protocols);
[[nodiscard]] nlohmann::json protocol_shape(const std::vector<std::string>& protocols);

/// Whether values spread so far that they need a logarithmic axis (and none of them forbids it).
[[nodiscard]] bool wants_log(const std::vector<double>& values);

/// An axis over `values` of the field `field`: logarithmic where they spread far, else linear.
[[nodiscard]] nlohmann::json value_axis(const std::string& field, const std::string& title,
                                        const std::vector<double>& values);

/// The linear form of value_axis.
[[nodiscard]] nlohmann::json linear_axis(const std::string& field, const std::string& title,
                                         const std::vector<double>& values);

/// The axis of sample percentages, falling from left to right, of the field `percent`.
[[nodiscard]] nlohmann::json percent_axis(const std::vector<double>& percents);

/// One line of a tooltip.
[[nodiscard]] nlohmann::json tip(const std::string& field, const std::string& title,
                                 const std::string& format = "");

/// A part of a stacked bar: its key in the results, its name and its colour in the chart.
struct StackPart {
    const char* key;
    const char* label;
    const char* color;  ///< of Okabe and Ito's palette
};

/// The position of `value` between the ends of value_axis or linear_axis, in [0, 1].
[[nodiscard]] double axis_position(const nlohmann::json& axis, double value);

}  // namespace coppice::report
