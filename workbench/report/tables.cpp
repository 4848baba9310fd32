#include "report/tables.h"

#include "report/chart_parts.h"
#include "report/format.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

struct Column {
    const char* key;
    const char* heading;
    const char* group;
};

// The columns of results.csv, but for those that are the same in the whole table.
constexpr std::array<Column, 22> row_columns{{
    {"protocol", "protocol", "Tree"},
    {"sample_percent", "sample", "Tree"},
    {"seed", "seed", "Tree"},
    {"split", "split", "Tree"},
    {"sampler", "sampler", "Tree"},
    {"sample_count", "sampled", "Primitives"},
    {"primitive_count", "all", "Primitives"},
    {"reference_count", "references", "Primitives"},
    {"node_count", "all", "Nodes"},
    {"inner_count", "inner", "Nodes"},
    {"leaf_count", "leaves", "Nodes"},
    {"single_primitive_leaf_count", "with one", "Leaves"},
    {"empty_leaf_count", "empty", "Leaves"},
    {"mean_leaf_size", "mean size", "Leaves"},
    {"max_level", "deepest level", "Leaves"},
    {"sample_seconds", "sample", "Time (ms)"},
    {"build_seconds", "build", "Time (ms)"},
    {"empty_seconds", "empty", "Time (ms)"},
    {"refill_seconds", "refill", "Time (ms)"},
    {"refine_seconds", "refine", "Time (ms)"},
    {"total_seconds", "total", "Time (ms)"},
    {"sah_cost", "SAH", "Cost"},
}};

std::string cell_text(const json& row, std::string_view key) {
    if (key == "protocol") return escape_html(protocol_style(text_at(row, key)).name);
    const std::optional<double> number = number_at(row, key);
    if (!number) {
        const std::string text = text_at(row, key);
        return text.empty() ? "–" : escape_html(text);
    }
    if (key == "sample_percent") return format_percent(*number);
    if (key == "seed") return fmt::format("{:.0f}", *number);
    if (key.ends_with("_seconds")) return escape_html(format_milliseconds(*number));
    if (key.ends_with("_count") || key == "max_level") return format_count(*number);
    return format_ratio(*number);
}

// Whether all rows of a kind agree at `key`, so that a column of it would say nothing.
bool is_constant(const json& rows, std::string_view kind, std::string_view key) {
    std::set<std::string> values;
    for (const json& row : rows) {
        if (text_at(row, "primitives") == kind) values.insert(cell_text(row, key));
    }
    return values.size() <= 1;
}

std::vector<Column> choose_columns(const json& rows, std::string_view kind) {
    std::vector<Column> columns;
    for (const Column& column : row_columns) {
        const std::string_view key = column.key;
        const bool may_go =
            key == "seed" || key == "split" || key == "sampler" || key == "primitive_count";
        if (!may_go || !is_constant(rows, kind, key)) columns.push_back(column);
    }
    columns.push_back({"relative_cost", "/ full tree", "Cost"});
    return columns;
}

std::string make_head(const std::vector<Column>& columns) {
    std::string groups;
    std::string headings;
    for (std::size_t i = 0; i < columns.size();) {
        std::size_t end = i;
        while (end < columns.size() && std::string_view(columns[end].group) == columns[i].group) {
            headings += fmt::format("<th scope=\"col\"{}>{}</th>",
                                    end == i ? " class=\"first\"" : "", columns[end].heading);
            ++end;
        }
        groups += fmt::format("<th scope=\"colgroup\" colspan=\"{}\" class=\"first\">{}</th>",
                              end - i, columns[i].group);
        i = end;
    }
    return fmt::format("<thead><tr>{}</tr><tr>{}</tr></thead>", groups, headings);
}

std::string scrollable(std::string_view label, const std::string& table) {
    return fmt::format(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</div>",
        escape_html(label), table);
}

std::string constants_of(const json& rows, std::string_view kind) {
    std::string text;
    for (const json& row : rows) {
        if (text_at(row, "primitives") != kind) continue;
        for (const char* key : {"primitive_count", "split", "sampler", "seed"}) {
            if (!is_constant(rows, kind, key)) continue;
            const std::string name =
                key == std::string_view("primitive_count") ? "primitives" : key;
            text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", name, cell_text(row, key));
        }
        break;
    }
    return text;
}

// "1.71" of the ratio, "–" where there is none.
std::string ratio_cell(const std::optional<double>& ratio) {
    return fmt::format("<td>{}</td>", ratio ? format_ratio(*ratio) : "–");
}

std::optional<double> mean_of(const RatePoint* point, std::string_view key) {
    const Range* range = point != nullptr ? point->find(key) : nullptr;
    return range != nullptr ? std::optional(range->mean) : std::nullopt;
}

std::string recommendation_rows(const json& scene, const Series& series) {
    std::string html;
    for (const std::string& protocol : series.protocols()) {
        const json* chosen = nullptr;
        for (const json& row : array_at(scene, "recommended")) {
            if (text_at(row, "primitives") == series.kind && series.line_of(row) == protocol) {
                chosen = &row;
            }
        }
        const json none = json::object();
        const json& row = chosen != nullptr ? *chosen : none;
        html += "<tr>";
        html += fmt::format(
            "<th scope=\"row\">{}</th><th scope=\"row\">{}</th><td class=\"key\">{}</td>",
            escape_html(series.kind), escape_html(protocol_style(protocol).name),
            cell_text(row, "sample_percent"));
        html += ratio_cell(number_at(row, "relative_cost"));
        html += ratio_cell(number_at(row, "relative_time"));
        const RatePoint* half = series.find(protocol, 50.0);
        html += ratio_cell(mean_of(half, "relative_cost"));
        html += ratio_cell(half != nullptr ? series.relative_time(*half) : std::nullopt);
        html += "</tr>";
    }
    return html;
}

std::vector<double> all_percents(const Series& series, const ThesisTables& thesis) {
    std::set<double, std::greater<>> percents;
    for (const RatePoint& point : series.points) {
        percents.insert(point.percent);
    }
    for (const ThesisRow& row : thesis.rows) {
        percents.insert(row.percent);
    }
    return {percents.begin(), percents.end()};
}

std::string thesis_cells(const ThesisTables& thesis, double percent, double ThesisRow::*measure) {
    std::string html;
    for (const std::string& scene : thesis.scenes()) {
        const ThesisRow* row = thesis.find(scene, percent);
        const ThesisRow* full = thesis.find(scene, 100.0);
        const bool is_known = row != nullptr && full != nullptr;
        html += ratio_cell(is_known ? std::optional(row->*measure / full->*measure) : std::nullopt);
    }
    return html;
}

void append_fields(const json& object, const std::string& prefix, std::string& html);

std::string field_text(std::string_view key, const json& value) {
    if (value.is_null()) return "not recorded";
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_string()) return escape_html(value.get<std::string>());
    if (value.is_array()) {
        std::string text;
        for (const json& item : value) {
            text += (text.empty() ? "" : ", ") + field_text(key, item);
        }
        return text.empty() ? "none" : text;
    }
    if (!value.is_number()) return escape_html(value.dump());
    const auto number = value.get<double>();
    if (key.ends_with("_bytes")) return format_bytes(number);
    if (key.ends_with("_seconds")) return format_duration(number);
    if (value.is_number_integer()) return format_count(number);
    return fmt::format("{:.6g}", number);
}

void append_fields(const json& object, const std::string& prefix, std::string& html) {
    for (const auto& [key, value] : object.items()) {
        std::string name = key;
        std::ranges::replace(name, '_', ' ');
        if (value.is_object()) {
            append_fields(value, prefix + name + " ", html);
            continue;
        }
        for (const std::string_view suffix : {" bytes", " seconds"}) {
            if (name.ends_with(suffix)) name.resize(name.size() - suffix.size());
        }
        html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>",
                            escape_html(prefix + name), field_text(key, value));
    }
}

}  // namespace

std::string make_rows_table(const json& scene, const Series& series) {
    const json& rows = array_at(scene, "rows");
    const std::vector<Column> columns = choose_columns(rows, series.kind);
    std::string body;
    for (const json& row : rows) {
        if (text_at(row, "primitives") != series.kind) continue;
        const RatePoint* point =
            series.find(series.line_of(row), number_at(row, "sample_percent").value_or(0.0));
        const bool is_recommended = point != nullptr && point->is_recommended;
        body += is_recommended ? "<tr class=\"recommended\">" : "<tr>";
        std::string_view group;
        for (const Column& column : columns) {
            const bool is_first = group != column.group;
            group = column.group;
            const std::string_view key = column.key;
            const bool is_head = key == "protocol" || key == "sample_percent";
            body += fmt::format("<{}{}>{}{}</{}>", is_head ? "th scope=\"row\"" : "td",
                                is_first ? " class=\"first\"" : "", cell_text(row, key),
                                is_recommended && key == "sample_percent" ? " ◎" : "",
                                is_head ? "th" : "td");
        }
        body += "</tr>\n";
    }
    const std::string label = fmt::format("All trees over the {} of {}", series.kind, series.scene);
    return scrollable(
        label,
        fmt::format(
            "<table class=\"rows sortable\"><caption>{}. {}.</caption>{}<tbody>{}</tbody></table>",
            escape_html(label), constants_of(rows, series.kind), make_head(columns), body));
}

std::string make_recommendation_table(const json& scene, const std::vector<Series>& series) {
    std::string body;
    for (const Series& kind : series) {
        body += recommendation_rows(scene, kind);
    }
    return scrollable(
        "Recommended samples of " + text_at(scene, "scene"),
        "<table class=\"recommendations sortable\"><caption>Costs and times are relative to the "
        "100&nbsp;% "
        "tree"
        " of the same protocol.</caption><thead><tr><th rowspan=\"2\" "
        "scope=\"col\">primitives</th>"
        "<th rowspan=\"2\" scope=\"col\">protocol</th>"
        "<th colspan=\"3\" scope=\"colgroup\" class=\"first\">recommended</th>"
        "<th colspan=\"2\" scope=\"colgroup\" class=\"first\">the thesis’s 50&nbsp;%</th></tr>"
        "<tr><th scope=\"col\" class=\"first\">sample</th><th scope=\"col\">cost ×</th>"
        "<th scope=\"col\">time ×</th><th scope=\"col\" class=\"first\">cost ×</th>"
        "<th scope=\"col\">time ×</th></tr></thead><tbody>" +
            body + "</tbody></table>");
}

std::string make_thesis_table(const Series& series, const ThesisTables& thesis) {
    std::string names;
    bool is_first = true;
    const auto add_name = [&](const std::string& name) {
        names += fmt::format("<th scope=\"col\"{}>{}</th>", is_first ? " class=\"first\"" : "",
                             escape_html(name));
        is_first = false;
    };
    const auto add_names = [&] {
        is_first = true;
        for (const std::string& scene : thesis.scenes()) {
            add_name(thesis_scene_title(scene));
        }
        is_first = true;
        for (const std::string& protocol : series.protocols()) {
            add_name(protocol_style(protocol).label);
        }
    };
    add_names();
    add_names();
    std::string body;
    for (const double percent : all_percents(series, thesis)) {
        body += fmt::format("<tr><th scope=\"row\">{}</th>", format_percent(percent));
        body += thesis_cells(thesis, percent, &ThesisRow::sah_cost);
        for (const std::string& protocol : series.protocols()) {
            body += ratio_cell(mean_of(series.find(protocol, percent), "relative_cost"));
        }
        body += thesis_cells(thesis, percent, &ThesisRow::build_seconds);
        for (const std::string& protocol : series.protocols()) {
            const RatePoint* point = series.find(protocol, percent);
            body += ratio_cell(point != nullptr ? series.relative_time(*point) : std::nullopt);
        }
        body += "</tr>\n";
    }
    const std::string here = escape_html(series.scene + ", " + series.kind);
    const std::size_t thesis_count = thesis.scenes().size();
    const std::size_t here_count = series.protocols().size();
    const auto group = [&](std::string_view measure) {
        return fmt::format(
            "<th scope=\"colgroup\" class=\"first\" colspan=\"{}\">{}: thesis</th>"
            "<th scope=\"colgroup\" class=\"first\" colspan=\"{}\">{}: {}</th>",
            thesis_count, measure, here_count, measure, here);
    };
    return scrollable(
        "The thesis's numbers and ours",
        fmt::format("<table class=\"sortable\"><caption>Relative to each scene’s own 100&nbsp;% "
                    "tree.</caption><thead><tr>"
                    "<th rowspan=\"2\" scope=\"col\">sample</th>{}{}</tr><tr>{}</tr></thead>"
                    "<tbody>{}</tbody></table>",
                    group("Cost"), group("Build time"), names, body));
}

std::string make_fields_table(const json& object, std::string_view caption) {
    std::string body;
    if (object.is_object()) append_fields(object, "", body);
    if (body.empty()) body = "<tr><td>not recorded</td></tr>";
    return fmt::format("<table class=\"fields\"><caption>{}</caption><tbody>{}</tbody></table>",
                       escape_html(caption), body);
}

}  // namespace coppice::report
