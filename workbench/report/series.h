#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::report {

/// A measure over the seeds.
struct Range {
    double mean = 0.0;
    double min = 0.0;
    double max = 0.0;
    std::optional<std::array<double, 2>> interval{};  ///< 95 % t interval of the mean

    /// What a band shows: the interval, or else the least and the greatest. One that reaches down
    /// to 0, as those of two seeds may, ends at half the least: logarithmic axes have no 0.
    [[nodiscard]] double band_low() const;
    [[nodiscard]] double band_high() const;
};

/// The trees of one protocol at one sample percentage, one for each seed.
struct RatePoint {
    std::string protocol;  ///< or method, with the sampler if it is another than usual: line_of()
    double percent = 0.0;
    std::size_t seed_count = 0;
    bool is_recommended = false;
    std::optional<double> relative_time{};  ///< mean over the seeds, where the results have it
    std::map<std::string, Range, std::less<>> measures{};  ///< by the results' own keys
    /// `depth_histogram` and `cost_share_by_depth`: the mean over the seeds, level by level.
    std::map<std::string, std::vector<double>, std::less<>> levels{};

    /// The measure called `name`, or null where no seed has a number for it.
    [[nodiscard]] const Range* find(std::string_view name) const;
};

/// All k-d trees built over one kind of primitive of one scene. The costs of others, which count
/// blocks of primitives or are not known, cannot be drawn beside theirs.
struct Series {
    std::size_t scene_index = 0;      ///< in the results' array of scenes
    std::string scene;                ///< as the results name it: any text
    std::string kind;                 ///< "points" or "triangles"
    std::string key;                  ///< "dragon-points": fit for ids, unique on the page
    std::string sampler{};            ///< the usual one: that of the first row
    std::vector<RatePoint> points{};  ///< by protocol, within it by falling percentage

    /// What a row of the results, or whatever is said of one, is called here: its protocol,
    /// "grown, weighted" if its sampler is not the usual one.
    [[nodiscard]] std::string line_of(const nlohmann::json& row) const;

    /// The protocols met, `fixed`, `scaled`, `grown` first and in this order.
    [[nodiscard]] std::vector<std::string> protocols() const;
    /// The percentages met, falling.
    [[nodiscard]] std::vector<double> percents() const;
    /// The point of a protocol at a percentage, or null.
    [[nodiscard]] const RatePoint* find(std::string_view protocol, double percent) const;
    /// Whether every point knows its cost relative to the 100 % tree.
    [[nodiscard]] bool has_relative_cost() const;
    /// The mean of `measure` at the point over its mean at 100 % of the same protocol; none where
    /// one of them is missing or the latter is 0.
    [[nodiscard]] std::optional<double> relative_to_full(const RatePoint& point,
                                                         std::string_view measure) const;
    /// The build time over that of the 100 % tree: the mean of the seeds' ratios as the results
    /// have it, or else the ratio of the means.
    [[nodiscard]] std::optional<double> relative_time(const RatePoint& point) const;
};

/// Every series of the results document, in its order.
/// Throws Error(invalid_argument) unless `results` is an object with an array `scenes` of objects.
[[nodiscard]] std::vector<Series> collect_series(const nlohmann::json& results);

/// The text at `key`, or "" where there is none.
[[nodiscard]] std::string text_at(const nlohmann::json& object, std::string_view key);

/// The finite number at `key`, where there is one.
[[nodiscard]] std::optional<double> number_at(const nlohmann::json& object, std::string_view key);

/// The array at `key`, or an empty one where there is none.
[[nodiscard]] const nlohmann::json& array_at(const nlohmann::json& object, std::string_view key);

}  // namespace coppice::report
