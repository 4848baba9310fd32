#include "scenes/scene_names.h"

#include <set>

namespace coppice::lab {

std::string scene_name(const std::filesystem::path& file) {
    std::filesystem::path name = file.filename();
    if (name.extension() == ".gz") name = name.stem();
    name = name.stem();
    return name.empty() ? "scene" : name.string();
}

std::vector<std::string> scene_names(std::span<const std::filesystem::path> files) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const auto& file : files) {
        const std::string name = scene_name(file);
        std::string unique = name;
        for (int n = 2; !taken.insert(unique).second; ++n) {
            unique = name + "-" + std::to_string(n);
        }
        names.push_back(unique);
    }
    return names;
}

std::filesystem::path default_output_folder(std::span<const std::filesystem::path> files) {
    std::string name = files.empty() ? "scene" : scene_name(files.front());
    if (files.size() > 1) name += "-and-" + std::to_string(files.size() - 1) + "-more";
    return std::filesystem::path("out") / name;
}

}  // namespace coppice::lab
