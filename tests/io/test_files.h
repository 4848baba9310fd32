// What the tests of reading and writing share: files made on the spot, and errors as text.
#pragma once

#include "coppice/base/error.h"
#include "coppice/geom/triangle_mesh.h"
#include "coppice/io/load_mesh.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace coppice::test {

/// A folder for all files of this process, removed when it ends.
class TestFolder {
public:
    TestFolder()
        : path_(std::filesystem::path(testing::TempDir()) /
                ("coppice_io_" + std::to_string(getpid()))) {}

    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// An empty folder.
[[nodiscard]] inline std::filesystem::path fresh_folder() {
    static const TestFolder all;
    static int number = 0;
    const std::filesystem::path folder = all.path() / std::to_string(number++);
    std::filesystem::create_directories(folder);
    return folder;
}

/// Writes `contents` into a file of a fresh folder.
inline std::filesystem::path make_file(const std::string& name, std::string_view contents) {
    const std::filesystem::path file = fresh_folder() / name;
    std::ofstream(file, std::ios::binary) << contents;
    return file;
}

/// A file of tests/data.
[[nodiscard]] inline std::filesystem::path data_file(const std::string& name) {
    return std::filesystem::path(COPPICE_TEST_DATA_DIR) / name;
}

[[nodiscard]] inline std::string read_file(const std::filesystem::path& file) {
    std::ostringstream contents;
    contents << std::ifstream(file, std::ios::binary).rdbuf();
    return contents.str();
}

/// `contents` as a gzip file.
[[nodiscard]] inline std::string gzipped(std::string_view contents) {
    const std::filesystem::path file = fresh_folder() / "packed.gz";
    gzFile packed = gzopen(file.c_str(), "wb");
    EXPECT_EQ(gzwrite(packed, contents.data(), static_cast<unsigned>(contents.size())),
              static_cast<int>(contents.size()));
    EXPECT_EQ(gzclose(packed), Z_OK);
    return read_file(file);
}

/// `text` with CRLF in place of LF.
[[nodiscard]] inline std::string with_crlf(std::string_view text) {
    std::string changed;
    for (const char c : text) {
        changed += c == '\n' ? "\r\n" : std::string(1, c);
    }
    return changed;
}

struct Loaded {
    TriangleMesh mesh;
    LoadReport report;
};

/// Loads a file made of `contents`.
[[nodiscard]] inline Loaded load(const std::string& name, std::string_view contents) {
    Loaded loaded;
    loaded.mesh = load_mesh(make_file(name, contents), &loaded.report);
    return loaded;
}

/// What load_mesh says about `file`, without the folder; "" if it loads it.
[[nodiscard]] inline std::string error_of_file(const std::filesystem::path& file,
                                               ErrorCode expected) {
    try {
        static_cast<void>(load_mesh(file));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), expected) << error.what();
        const std::string what = error.what();
        const std::string folder = file.parent_path().string() + "/";
        EXPECT_TRUE(what.starts_with(folder)) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        return what.substr(folder.size());
    }
    return "";
}

/// What load_mesh says about a file made of `contents`, without the folder; "" if it loads it.
[[nodiscard]] inline std::string error_of(const std::string& name, std::string_view contents,
                                          ErrorCode expected = ErrorCode::parse) {
    return error_of_file(make_file(name, contents), expected);
}

/// The bits of all coordinates, then of all indices: equal for equal meshes only.
[[nodiscard]] inline std::vector<std::uint32_t> bits_of(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> bits;
    for (const Vec3f& vertex : mesh.vertices) {
        for (const Axis axis : all_axes) {
            bits.push_back(std::bit_cast<std::uint32_t>(vertex[axis]));
        }
    }
    for (const TriangleIndices& corners : mesh.triangles) {
        bits.insert(bits.end(), corners.begin(), corners.end());
    }
    return bits;
}

/// While it lives, root has the rights of a user who owns nothing; others have theirs.
class WithoutRights {
public:
    WithoutRights() : old_user_(geteuid()) {
        EXPECT_EQ(seteuid(old_user_ == 0 ? 65534 : old_user_), 0);
    }

    ~WithoutRights() { EXPECT_EQ(seteuid(old_user_), 0); }

    WithoutRights(const WithoutRights&) = delete;
    WithoutRights& operator=(const WithoutRights&) = delete;

private:
    uid_t old_user_;
};

/// `value` as bytes, in the byte order that a binary PLY format names.
template <typename T>
[[nodiscard]] std::string binary(T value, bool is_big_endian) {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
    return is_big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

}  // namespace coppice::test
