#include "scenes/mesh_summary.h"

#include "coppice/geom/point_cloud.h"

#include "statistics/percentile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace coppice::lab {

namespace {

std::vector<double> sorted_areas(TriangleMeshView mesh) {
    std::vector<double> areas;
    areas.reserve(mesh.size());
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
        areas.push_back(triangle_area(mesh.triangle(id)));
    }
    std::sort(areas.begin(), areas.end());
    return areas;
}

std::vector<AreaDecade> count_decades(const std::vector<double>& areas) {
    std::map<int, std::uint64_t> counts;
    for (const double area : areas) {
        if (area > 0.0) ++counts[static_cast<int>(std::floor(std::log10(area)))];
    }
    std::vector<AreaDecade> decades;
    if (counts.empty()) return decades;
    for (int exponent = counts.begin()->first; exponent <= counts.rbegin()->first; ++exponent) {
        const auto found = counts.find(exponent);
        decades.push_back({exponent, found == counts.end() ? 0 : found->second});
    }
    return decades;
}

AreaDistribution summarize_areas(TriangleMeshView mesh) {
    AreaDistribution distribution;
    if (mesh.size() == 0) return distribution;
    const std::vector<double> areas = sorted_areas(mesh);
    for (const double area : areas) {
        distribution.total += area;
        if (area == 0.0) ++distribution.zero_count;
    }
    distribution.min = areas.front();
    distribution.max = areas.back();
    distribution.mean = distribution.total / static_cast<double>(areas.size());
    for (std::size_t i = 0; i < AreaDistribution::percents.size(); ++i) {
        distribution.percentiles[i] =
            percentile_of(areas, static_cast<std::size_t>(AreaDistribution::percents[i]));
    }
    distribution.decades = count_decades(areas);
    return distribution;
}

EdgeCounts count_edges(TriangleMeshView mesh) {
    std::vector<std::uint64_t> edges;
    edges.reserve(std::size_t{3} * mesh.size());
    for (const TriangleIndices& corners : mesh.triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [from, to] = std::minmax({corners[i], corners[(i + 1) % 3]});
            if (from != to) edges.push_back(std::uint64_t{from} << 32 | to);
        }
    }
    std::sort(edges.begin(), edges.end());
    EdgeCounts counts;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::upper_bound(first, edges.end(), *first);
        const auto triangles = last - first;
        ++counts.edges;
        if (triangles == 1) ++counts.boundary;
        if (triangles > 2) ++counts.non_manifold;
        first = last;
    }
    return counts;
}

nlohmann::json areas_json(const AreaDistribution& areas) {
    nlohmann::json percentiles = nlohmann::json::object();
    for (std::size_t i = 0; i < AreaDistribution::percents.size(); ++i) {
        percentiles[std::to_string(AreaDistribution::percents[i])] = areas.percentiles[i];
    }
    nlohmann::json decades = nlohmann::json::array();
    for (const AreaDecade& decade : areas.decades) {
        decades.push_back({{"exponent", decade.exponent}, {"count", decade.count}});
    }
    return {{"min", areas.min},     {"max", areas.max},           {"mean", areas.mean},
            {"total", areas.total}, {"percentiles", percentiles}, {"zero_count", areas.zero_count},
            {"decades", decades}};
}

}  // namespace

MeshSummary summarize(TriangleMeshView mesh) {
    MeshSummary summary;
    summary.vertex_count = mesh.vertices().size();
    summary.distinct_vertex_count = shuffled_distinct_points(mesh.vertices(), 1).size();
    summary.triangle_count = mesh.size();
    summary.bounds = bounds_of(mesh.vertices());
    summary.areas = summarize_areas(mesh);
    summary.edges = count_edges(mesh);
    return summary;
}

void to_json(nlohmann::json& json, const MeshSummary& summary) {
    json = {{"vertex_count", summary.vertex_count},
            {"distinct_vertex_count", summary.distinct_vertex_count},
            {"triangle_count", summary.triangle_count},
            {"bounds", bounds_json(summary.bounds)},
            {"areas", areas_json(summary.areas)},
            {"edges",
             {{"count", summary.edges.edges},
              {"boundary_count", summary.edges.boundary},
              {"non_manifold_count", summary.edges.non_manifold}}}};
}

nlohmann::json bounds_json(const Aabb& bounds) {
    if (bounds.is_empty()) return nullptr;
    const auto corner = [](Vec3f v) { return nlohmann::json{v.x, v.y, v.z}; };
    return {{"lower", corner(bounds.lower)}, {"upper", corner(bounds.upper)}};
}

}  // namespace coppice::lab
