#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coppice::report {

/// One row of the thesis's tables. Source: [Tsiompikas2022] figures 2 to 8.
struct ThesisRow {
    std::string scene;  ///< "living_room", "bmw", "bistro" or "dragon"
    double primitive_count = 0.0;
    double percent = 0.0;
    double sah_cost = 0.0;
    double build_seconds = 0.0;  ///< whole seconds, as published
    double node_count = 0.0;
    double max_level = 0.0;
};

/// All trees of the thesis, scene by scene, each by falling percentage.
struct ThesisTables {
    std::vector<ThesisRow> rows;

    /// The scenes in their order.
    [[nodiscard]] std::vector<std::string> scenes() const;
    /// The row of a scene at a percentage, or null.
    [[nodiscard]] const ThesisRow* find(std::string_view scene, double percent) const;
};

/// Reads the tables; lines that start with # are comments, the first other one is the header.
/// Throws Error(parse) where a row has not the header's seven columns.
[[nodiscard]] ThesisTables parse_thesis_tables(std::string_view csv);

/// The tables that are part of the program.
[[nodiscard]] const ThesisTables& thesis_tables();

/// A scene as a reader calls it: "living room".
[[nodiscard]] std::string thesis_scene_title(std::string_view scene);

}  // namespace coppice::report
