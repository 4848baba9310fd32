#include "report/series.h"

#include "coppice/base/error.h"

#include "report/format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <tuple>
#include <utility>

namespace coppice::report {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> known_protocols{"fixed", "scaled", "grown"};
constexpr std::array<std::string_view, 2> level_keys{"depth_histogram", "cost_share_by_depth"};

double percent_of(const json& row) {
    return number_at(row, "sample_percent").value_or(0.0);
}

std::size_t protocol_rank(std::string_view protocol) {
    return static_cast<std::size_t>(std::ranges::find(known_protocols, protocol) -
                                    known_protocols.begin());
}

std::string make_unique(const std::string& slug, std::set<std::string>& taken) {
    std::string unique = slug;
    for (int number = 2; !taken.insert(unique).second; ++number) {
        unique = slug + "-" + std::to_string(number);
    }
    return unique;
}

// Rows of the results tell it by their split rule, details by the form of the tree.
bool is_kd(const json& row) {
    const bool has_rule = !row.contains("split") || !text_at(row, "split").empty();
    return has_rule && (!row.contains("tree") || text_at(row, "tree") == "kd");
}

RatePoint& point_of(Series& series, const json& row) {
    const std::string protocol = series.line_of(row);
    const double percent = percent_of(row);
    for (RatePoint& point : series.points) {
        if (point.protocol == protocol && point.percent == percent) return point;
    }
    series.points.push_back({.protocol = protocol, .percent = percent});
    return series.points.back();
}

// Collects what one tree measured; finish_means turns the sums into means.
void add_measures(RatePoint& point, const json& row,
                  std::map<std::string, std::size_t>& counts_by_key) {
    for (const auto& [key, value] : row.items()) {
        const std::optional<double> number = number_at(row, key);
        if (!number) continue;
        Range& range =
            point.measures.try_emplace(key, Range{0.0, *number, *number, {}}).first->second;
        range.mean += *number;
        range.min = std::min(range.min, *number);
        range.max = std::max(range.max, *number);
        ++counts_by_key[key];
    }
    for (const std::string_view key : level_keys) {
        const json& shares = array_at(row, key);
        if (shares.empty()) continue;
        std::vector<double>& sums = point.levels[std::string(key)];
        sums.resize(std::max(sums.size(), shares.size()), 0.0);
        for (std::size_t level = 0; level < shares.size(); ++level) {
            if (shares[level].is_number()) sums[level] += shares[level].get<double>();
        }
        ++counts_by_key[std::string(key)];
    }
}

void finish_means(RatePoint& point, const std::map<std::string, std::size_t>& counts_by_key) {
    for (auto& [key, range] : point.measures) {
        range.mean /= static_cast<double>(counts_by_key.at(key));
    }
    for (auto& [key, sums] : point.levels) {
        for (double& sum : sums) {
            sum /= static_cast<double>(counts_by_key.at(key));
        }
    }
}

// What the results say of all seeds of a point together.
void add_summaries(Series& series, const json& scene) {
    for (const json& summary : array_at(scene, "summary")) {
        if (text_at(summary, "primitives") != series.kind) continue;
        for (RatePoint& point : series.points) {
            const bool is_same =
                point.protocol == series.line_of(summary) && point.percent == percent_of(summary);
            if (!is_same) continue;
            const auto time = summary.find("relative_time");
            if (time != summary.end()) point.relative_time = number_at(*time, "mean");
            for (auto& [key, range] : point.measures) {
                const auto at = summary.find(key);
                if (at == summary.end()) continue;
                const std::optional<double> low = number_at(*at, "low");
                const std::optional<double> high = number_at(*at, "high");
                if (low && high) range.interval = {*low, *high};
            }
        }
    }
}

// Means over the seeds of all rows of the series' kind.
void collect_points(Series& series, const json& scene) {
    for (const json& row : array_at(scene, "rows")) {
        if (text_at(row, "primitives") != series.kind) continue;
        series.sampler = text_at(row, "sampler");
        break;
    }
    std::map<std::pair<std::string, double>, std::map<std::string, std::size_t>> counts;
    const auto add = [&](const json& row) -> RatePoint* {
        if (text_at(row, "primitives") != series.kind || !is_kd(row)) return nullptr;
        RatePoint& point = point_of(series, row);
        add_measures(point, row, counts[{point.protocol, point.percent}]);
        return &point;
    };
    for (const json& row : array_at(scene, "rows")) {
        if (RatePoint* point = add(row)) ++point->seed_count;
    }
    for (const json& row : array_at(scene, "details")) {
        add(row);
    }
    for (const json& row : array_at(scene, "recommended")) {
        if (text_at(row, "primitives") != series.kind) continue;
        for (RatePoint& point : series.points) {
            if (point.protocol == series.line_of(row) && point.percent == percent_of(row)) {
                point.is_recommended = true;
            }
        }
    }
    for (RatePoint& point : series.points) {
        finish_means(point, counts[{point.protocol, point.percent}]);
    }
    add_summaries(series, scene);
    std::erase_if(series.points, [](const RatePoint& point) {
        return point.seed_count == 0 || !(point.percent > 0.0);
    });
    std::ranges::stable_sort(series.points, {}, [](const RatePoint& point) {
        return std::tuple(protocol_rank(point.protocol), point.protocol, -point.percent);
    });
}

// In the order of their first rows.
std::vector<std::string> find_kinds(const json& scene) {
    std::vector<std::string> kinds;
    for (const json& row : array_at(scene, "rows")) {
        std::string kind = text_at(row, "primitives");
        if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(std::move(kind));
    }
    return kinds;
}

}  // namespace

double Range::band_low() const {
    return interval ? std::max(interval->front(), 0.5 * min) : min;
}

double Range::band_high() const {
    return interval ? interval->back() : max;
}

const Range* RatePoint::find(std::string_view name) const {
    const auto at = measures.find(name);
    return at == measures.end() ? nullptr : &at->second;
}

std::string Series::line_of(const json& row) const {
    const std::string row_sampler = text_at(row, "sampler");
    const std::string protocol = text_at(row, "protocol");
    return row_sampler.empty() || row_sampler == sampler ? protocol : protocol + ", " + row_sampler;
}

std::vector<std::string> Series::protocols() const {
    std::vector<std::string> names;
    for (const RatePoint& point : points) {
        if (names.empty() || names.back() != point.protocol) names.push_back(point.protocol);
    }
    return names;
}

std::vector<double> Series::percents() const {
    std::set<double, std::greater<>> percents;
    for (const RatePoint& point : points) {
        percents.insert(point.percent);
    }
    return {percents.begin(), percents.end()};
}

const RatePoint* Series::find(std::string_view protocol, double percent) const {
    const auto at = std::ranges::find_if(points, [&](const RatePoint& point) {
        return point.protocol == protocol && point.percent == percent;
    });
    return at == points.end() ? nullptr : &*at;
}

bool Series::has_relative_cost() const {
    return std::ranges::all_of(points, [](const RatePoint& point) {
        const Range* cost = point.find("relative_cost");
        return cost != nullptr && cost->mean > 0.0;
    });
}

std::optional<double> Series::relative_to_full(const RatePoint& point,
                                               std::string_view measure) const {
    const RatePoint* full = find(point.protocol, 100.0);
    const Range* whole = full != nullptr ? full->find(measure) : nullptr;
    const Range* part = point.find(measure);
    if (whole == nullptr || part == nullptr || !(whole->mean > 0.0)) return std::nullopt;
    return part->mean / whole->mean;
}

std::optional<double> Series::relative_time(const RatePoint& point) const {
    return point.relative_time ? point.relative_time : relative_to_full(point, "total_seconds");
}

std::vector<Series> collect_series(const json& results) {
    if (!results.is_object() || !results.contains("scenes") || !results["scenes"].is_array()) {
        throw Error(ErrorCode::invalid_argument, "not a results document: no array \"scenes\"");
    }
    std::vector<Series> collected;
    std::set<std::string> slugs;
    std::size_t index = 0;
    for (const json& scene : results["scenes"]) {
        if (!scene.is_object()) {
            throw Error(ErrorCode::invalid_argument,
                        "not a results document: a scene is no object");
        }
        const std::string name = text_at(scene, "scene");
        const std::string slug = make_unique(make_slug(name), slugs);
        for (const std::string& kind : find_kinds(scene)) {
            Series series{.scene_index = index,
                          .scene = name,
                          .kind = kind,
                          .key = slug + "-" + make_slug(kind)};
            collect_points(series, scene);
            if (!series.points.empty()) collected.push_back(std::move(series));
        }
        ++index;
    }
    return collected;
}

std::string text_at(const json& object, std::string_view key) {
    if (!object.is_object()) return {};
    const auto at = object.find(key);
    return at != object.end() && at->is_string() ? at->get<std::string>() : std::string();
}

std::optional<double> number_at(const json& object, std::string_view key) {
    if (!object.is_object()) return std::nullopt;
    const auto at = object.find(key);
    if (at == object.end() || !at->is_number() || !std::isfinite(at->get<double>())) {
        return std::nullopt;
    }
    return at->get<double>();
}

const json& array_at(const json& object, std::string_view key) {
    static const json empty = json::array();
    if (!object.is_object()) return empty;
    const auto at = object.find(key);
    return at != object.end() && at->is_array() ? *at : empty;
}

}  // namespace coppice::report
