// A user of the whole library: a mesh from a file, its report as JSON, and the formats there are.
#include <coppice/coppice.h>
#include <coppice/json/load_report.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <string>

namespace {

/// What load_mesh() says to a triangle as STL; "" if it loads it.
std::string error_of_stl() {
    std::ofstream("triangle.stl") << "solid a\nfacet normal 0 0 1\nouter loop\nvertex -1 -1 0\n"
                                     "vertex 1 -1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
    try {
        static_cast<void>(coppice::load_mesh("triangle.stl"));
        return "";
    } catch (const coppice::Error& error) {
        return error.what();
    }
}

}  // namespace

int main() {
    std::ofstream("triangle.obj") << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    coppice::LoadReport report;
    const coppice::Scene scene(coppice::load_mesh("triangle.obj", &report));
    const bool hits = scene.occluded({.origin = {0, 0, -5}, .direction = {0, 0, 1}});
    const bool has_json = nlohmann::json(report).at("triangle_count") == 1;
    const std::string error = error_of_stl();
    const bool stl_as_told = coppice::can_load_scene_files()
                                 ? error.empty()
                                 : error.find(".stl") < error.find("Assimp") &&
                                       error.find("Assimp") != std::string::npos;
    std::printf("%s; STL: %s\n", nlohmann::json(report).dump().c_str(), error.c_str());
    return hits && has_json && stl_as_told ? 0 : 1;
}
