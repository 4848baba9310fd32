#include "report/thesis_data.h"

#include "coppice/base/error.h"

#include "report/assets.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace coppice::report {
namespace {

constexpr std::string_view header =
    "scene,primitive_count,sample_percent,sah_cost,build_seconds,node_count,max_level";

std::string_view take_until(std::string_view& text, char end) {
    const std::size_t at = std::min(text.find(end), text.size());
    const std::string_view taken = text.substr(0, at);
    text.remove_prefix(std::min(at + 1, text.size()));
    return taken;
}

ThesisRow parse_row(std::string_view line, std::size_t number) {
    ThesisRow row{.scene = std::string(take_until(line, ','))};
    const std::array values{&row.primitive_count, &row.percent,    &row.sah_cost,
                            &row.build_seconds,   &row.node_count, &row.max_level};
    bool is_good = !row.scene.empty();
    for (double* value : values) {
        const std::string_view cell = take_until(line, ',');
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), *value);
        is_good = is_good && error == std::errc() && end == cell.data() + cell.size();
    }
    if (!is_good || !line.empty()) {
        throw file_error(ErrorCode::parse, "thesis_tables.csv", number, "not a row of numbers");
    }
    return row;
}

}  // namespace

std::vector<std::string> ThesisTables::scenes() const {
    std::vector<std::string> names;
    for (const ThesisRow& row : rows) {
        if (std::ranges::find(names, row.scene) == names.end()) names.push_back(row.scene);
    }
    return names;
}

const ThesisRow* ThesisTables::find(std::string_view scene, double percent) const {
    const auto at = std::ranges::find_if(
        rows, [&](const ThesisRow& row) { return row.scene == scene && row.percent == percent; });
    return at == rows.end() ? nullptr : &*at;
}

ThesisTables parse_thesis_tables(std::string_view csv) {
    ThesisTables tables;
    bool has_header = false;
    for (std::size_t number = 1; !csv.empty(); ++number) {
        const std::string_view line = take_until(csv, '\n');
        if (line.empty() || line.starts_with('#')) continue;
        if (has_header) {
            tables.rows.push_back(parse_row(line, number));
        } else if (line == header) {
            has_header = true;
        } else {
            throw file_error(ErrorCode::parse, "thesis_tables.csv", number, "not the header");
        }
    }
    return tables;
}

const ThesisTables& thesis_tables() {
    static const ThesisTables tables = parse_thesis_tables(embedded_assets().thesis_csv);
    return tables;
}

std::string thesis_scene_title(std::string_view scene) {
    if (scene == "bmw") return "BMW";
    if (scene == "bistro") return "Bistro";
    std::string title(scene);
    std::ranges::replace(title, '_', ' ');
    return title;
}

}  // namespace coppice::report
