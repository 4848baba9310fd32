// Geometry with 16 bits a coordinate, which is finer than any screen.
// Indices of a mesh mostly lie close to their predecessor, and so take little more than a byte
// each.

#include "report/inspector_data.h"

#include "report/base64.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace coppice::report {
namespace {

using nlohmann::json;

constexpr double most = 65535.0;
constexpr double log_range = 40.0;  // powers of two between the least and the greatest

/// Appends a number in [0, 1] as 16 bits.
void append_fraction(std::string& bytes, double fraction) {
    const auto code =
        static_cast<std::uint16_t>(std::lround(std::clamp(fraction, 0.0, 1.0) * most));
    bytes += static_cast<char>(code & 255U);
    bytes += static_cast<char>(code >> 8U);
}

void append_point(std::string& bytes, Vec3f point, const Aabb& bounds) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const double extent = bounds.extent(axis);
        const double offset = double{point[axis]} - double{bounds.lower[axis]};
        append_fraction(bytes, extent > 0.0 ? offset / extent : 0.0);
    }
}

/// A number of any sign, small ones in few bytes.
void append_zigzag(std::string& bytes, std::int64_t value) {
    auto rest =
        (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63U);
    for (; rest >= 128; rest >>= 7U) {
        bytes += static_cast<char>((rest & 127U) | 128U);
    }
    bytes += static_cast<char>(rest);
}

void put_triangles(const SceneOutline& outline, const Aabb& bounds, json& data) {
    std::unordered_map<std::string, std::uint32_t> known;  // quantized position to index
    std::vector<std::uint32_t> index_of(outline.positions.size());
    std::string positions;
    for (std::size_t i = 0; i < outline.positions.size(); ++i) {
        std::string point;
        append_point(point, outline.positions[i], bounds);
        const auto next = static_cast<std::uint32_t>(known.size());
        const auto [place, is_new] = known.emplace(std::move(point), next);
        if (is_new) positions += place->first;
        index_of[i] = place->second;
    }
    std::string indices;
    std::int64_t previous = 0;
    for (const TriangleIndices& triangle : outline.triangles) {
        for (const std::uint32_t corner : triangle) {
            append_zigzag(indices, index_of[corner] - previous);
            previous = index_of[corner];
        }
    }
    data["positions"] = base64(positions);
    data["indices"] = base64(indices);
    data["index_count"] = 3 * outline.triangles.size();
}

void put_points(const SceneOutline& outline, const Aabb& bounds, json& data) {
    std::string positions;
    for (const Vec3f point : outline.positions) {
        append_point(positions, point, bounds);
    }
    data["positions"] = base64(positions);
    data["shades"] = base64(std::string(outline.shades.begin(), outline.shades.end()));
}

json tree_data(const std::vector<CellLevel>& levels, const Aabb& bounds) {
    json heads = json::array();
    std::string boxes;
    std::string shares;
    std::string counts;
    for (const CellLevel& level : levels) {
        heads.push_back({level.cell_count, level.empty_count, level.shown.size()});
        for (const Cell& cell : level.shown) {
            append_point(boxes, cell.box.lower, bounds);
            append_point(boxes, cell.box.upper, bounds);
            append_fraction(
                shares, cell.cost_share > 0.0 ? 1.0 + std::log2(cell.cost_share) / log_range : 0.0);
            const auto count = static_cast<double>(cell.reference_count);
            append_fraction(counts, std::log2(1.0 + count) / log_range);
        }
    }
    return {{"levels", heads},
            {"boxes", base64(boxes)},
            {"shares", base64(shares)},
            {"counts", base64(counts)}};
}

json vector_json(Vec3f v) {
    return {v.x, v.y, v.z};
}

}  // namespace

json inspector_data(const Inspector& inspector) {
    const Aabb& bounds = inspector.bounds;
    const Viewpoint& viewpoint = inspector.viewpoint;
    json data{
        {"bounds", {{"lower", vector_json(bounds.lower)}, {"upper", vector_json(bounds.upper)}}},
        {"viewpoint",
         {{"eye", vector_json(viewpoint.eye)},
          {"look_at", vector_json(viewpoint.look_at)},
          {"up", vector_json(viewpoint.up)},
          {"fov", viewpoint.fov}}}};
    if (inspector.outline.triangles.empty()) {
        put_points(inspector.outline, bounds, data);
    } else {
        put_triangles(inspector.outline, bounds, data);
    }
    data["trees"] = json::array({tree_data(inspector.full, bounds)});
    if (!inspector.other.empty()) data["trees"].push_back(tree_data(inspector.other, bounds));
    return data;
}

}  // namespace coppice::report
