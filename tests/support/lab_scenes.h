// What the tests of the laboratory share: small scenes as files, in a folder of the test's own.
#pragma once

#include "coppice/io/save_mesh.h"

#include "scenes/procedural.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace coppice::lab::test {

/// A new folder, removed with all that is in it at the end of its life.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = testing::TempDir() + "coppice_lab_XXXXXX";
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
        path_ = name;
    }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

    /// Writes a file of these contents.
    [[nodiscard]] std::filesystem::path make_file(const std::string& name,
                                                  std::string_view contents) const {
        std::ofstream(path_ / name, std::ios::binary) << contents;
        return path_ / name;
    }

    /// Writes a procedural scene.
    [[nodiscard]] std::filesystem::path make_scene(const std::string& name, std::string_view kind,
                                                   std::uint32_t triangle_count) const {
        save_mesh(make_procedural(kind, triangle_count, 1).view(), path_ / name);
        return path_ / name;
    }

    /// Writes a PLY file of some points and no faces.
    [[nodiscard]] std::filesystem::path make_point_cloud(const std::string& name) const {
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex 100\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n";
        for (int i = 0; i < 100; ++i) {
            text += std::to_string(i % 10) + ' ' + std::to_string(i / 10) + ' ' +
                    std::to_string(i * i % 17) + '\n';
        }
        return make_file(name, text);
    }

    /// Names of all files and folders within, sorted, one a line.
    [[nodiscard]] std::string listing() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
            names.push_back(std::filesystem::relative(entry.path(), path_).string());
        }
        std::sort(names.begin(), names.end());
        std::string text;
        for (const std::string& name : names) {
            text += name + '\n';
        }
        return text;
    }

private:
    std::filesystem::path path_;
};

inline std::string read_file(const std::filesystem::path& file) {
    std::ostringstream contents;
    contents << std::ifstream(file, std::ios::binary).rdbuf();
    return contents.str();
}

}  // namespace coppice::lab::test
