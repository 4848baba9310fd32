#include "compare/circumstances.h"

#include <fmt/format.h>

#include <map>

namespace coppice::lab {

namespace {

using nlohmann::json;

/// What the rays of each scene were made from; nothing of scenes that have none.
std::map<std::string, json> ray_origins(const json& document) {
    std::map<std::string, json> origins;
    for (const json& scene : document["scenes"]) {
        const json rays = scene.value("rays", json());
        if (!rays.is_object()) continue;
        origins[scene.value("scene", "")] = {rays.value("camera", json()),
                                             rays.value("light", json()),
                                             rays.value("ray_counts", json())};
    }
    return origins;
}

}  // namespace

std::vector<std::string> find_notes(const json& before, const json& after) {
    std::vector<std::string> notes;
    const auto value = [](const json& document, const char* group, const char* key) {
        return document.contains(group) && document[group].contains(key) ? document[group][key]
                                                                         : json();
    };
    for (const char* key : {"cpu", "cores"}) {
        const json a = value(before, "machine", key);
        const json b = value(after, "machine", key);
        if (a != b) {
            notes.push_back(
                fmt::format("machines differ in {} ({}, {}): seconds cannot be compared", key,
                            a.dump(), b.dump()));
        }
    }
    json options = before.value("options", json::object());
    options.update(after.value("options", json::object()));  // the keys of both
    for (const auto& [key, ignored] : options.items()) {
        const bool is_place = key == "out" || key == "scenes" || key == "views";
        const json a = value(before, "options", key.c_str());
        const json b = value(after, "options", key.c_str());
        if (is_place || a == b) continue;
        notes.push_back(fmt::format("options differ in {} ({}, {})", key, a.dump(), b.dump()));
    }
    return notes;
}

std::vector<std::string> scenes_of_other_rays(const json& before, const json& after) {
    std::vector<std::string> scenes;
    const std::map<std::string, json> others = ray_origins(after);
    for (const auto& [scene, origin] : ray_origins(before)) {
        const auto other = others.find(scene);
        if (other != others.end() && other->second != origin) scenes.push_back(scene);
    }
    return scenes;
}

}  // namespace coppice::lab
