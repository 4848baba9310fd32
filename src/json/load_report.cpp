#include "coppice/json/load_report.h"

#include <nlohmann/json.hpp>

namespace coppice::inline v0 {

void to_json(nlohmann::json& json, const LoadIssue& issue) {
    json = {{"count", issue.count}, {"first", issue.first}};
}

void to_json(nlohmann::json& json, const LoadReport& report) {
    json = {
        {"file", report.file},
        {"format", report.format},
        {"file_bytes", report.file_bytes},
        {"load_seconds", report.load_seconds},
        {"vertex_count", report.vertex_count},
        {"face_count", report.face_count},
        {"triangle_count", report.triangle_count},
        {"polygons", report.polygons},
        {"degenerate_faces", report.degenerate_faces},
        {"zero_area_triangles", report.zero_area_triangles},
        {"duplicate_triangles", report.duplicate_triangles},
        {"duplicate_vertices", report.duplicate_vertices},
        {"unused_vertices", report.unused_vertices},
        {"negative_index_count", report.negative_index_count},
        {"ignored_line_count", report.ignored_line_count},
        {"ignored_element_count", report.ignored_element_count},
        {"trailing_byte_count", report.trailing_byte_count},
        {"warning_count", report.warning_count},
        {"warnings", report.warnings},
    };
}

}  // namespace coppice::inline v0
