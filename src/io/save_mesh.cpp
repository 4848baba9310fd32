#include "coppice/io/save_mesh.h"

#include "coppice/base/error.h"

#include "base/out_of_memory.h"
#include "io/new_file.h"
#include "io/text.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>

namespace coppice::inline v0 {

namespace {

/// Writes a mesh to a file in chunks, so that the whole text is never in memory.
class ChunkWriter {
public:
    explicit ChunkWriter(NewFile& file) : file_(file) {}

    fmt::memory_buffer& buffer() noexcept { return buffer_; }

    /// Call it after each item, which must be small compared with a chunk.
    void flush_if_full() {
        if (buffer_.size() >= chunk_bytes) {
            flush();
        }
    }

    void flush() {
        file_.write({buffer_.data(), buffer_.size()});
        buffer_.clear();
    }

private:
    static constexpr std::size_t chunk_bytes = std::size_t{1} << 18;

    NewFile& file_;
    fmt::memory_buffer buffer_;
};

void write_obj(TriangleMeshView mesh, NewFile& file) {
    ChunkWriter chunks(file);
    const auto out = std::back_inserter(chunks.buffer());
    for (const Vec3f& vertex : mesh.vertices()) {
        fmt::format_to(out, FMT_COMPILE("v {} {} {}\n"), vertex.x, vertex.y, vertex.z);
        chunks.flush_if_full();
    }
    for (const TriangleIndices& corners : mesh.triangles()) {
        // OBJ counts from 1. Uses 64 bits, because the last id would wrap around in 32.
        fmt::format_to(out, FMT_COMPILE("f {} {} {}\n"), corners[0] + std::uint64_t{1},
                       corners[1] + std::uint64_t{1}, corners[2] + std::uint64_t{1});
        chunks.flush_if_full();
    }
    chunks.flush();
}

void write_ply(TriangleMeshView mesh, NewFile& file) {
    static_assert(std::endian::native == std::endian::little && sizeof(Vec3f) == 12);
    // Uses int where possible: many readers do not support lists of uint.
    const bool fits_int = mesh.vertices().size() <= std::numeric_limits<std::int32_t>::max();
    file.write(
        fmt::format("ply\n"
                    "format binary_little_endian 1.0\n"
                    "element vertex {}\n"
                    "property float x\n"
                    "property float y\n"
                    "property float z\n"
                    "element face {}\n"
                    "property list uchar {} vertex_indices\n"
                    "end_header\n",
                    mesh.vertices().size(), mesh.triangles().size(), fits_int ? "int" : "uint"));
    file.write(
        {reinterpret_cast<const char*>(mesh.vertices().data()), mesh.vertices().size_bytes()});
    ChunkWriter chunks(file);
    for (const TriangleIndices& corners : mesh.triangles()) {
        const auto* const bytes = reinterpret_cast<const char*>(corners.data());
        chunks.buffer().push_back(3);
        chunks.buffer().append(bytes, bytes + sizeof(corners));
        chunks.flush_if_full();
    }
    chunks.flush();
}

/// Throws Error for a mesh that load_mesh() would reject.
void check_is_writable(TriangleMeshView mesh, bool is_obj, const std::string& file) {
    const auto is_in_range = [&](const TriangleIndices& corners) {
        return *std::max_element(corners.begin(), corners.end()) < mesh.vertices().size();
    };
    if (!std::all_of(mesh.vertices().begin(), mesh.vertices().end(), is_finite)) {
        throw file_error(ErrorCode::invalid_argument, file,
                         "the mesh has a vertex that is not finite");
    }
    if (!std::all_of(mesh.triangles().begin(), mesh.triangles().end(), is_in_range)) {
        throw file_error(ErrorCode::invalid_argument, file,
                         "the mesh has a vertex index out of range");
    }
    if (mesh.vertices().empty()) {
        throw file_error(ErrorCode::unsupported, file, "the mesh has no vertices");
    }
    if (is_obj && mesh.triangles().empty()) {
        throw file_error(ErrorCode::unsupported, file,
                         "the mesh has no triangles: save a point cloud as .ply");
    }
}

}  // namespace

void save_mesh(TriangleMeshView mesh, const std::filesystem::path& file) {
    with_memory_errors(file, [&] {
        const std::string extension = to_lower(file.extension().string());
        const bool is_obj = extension == ".obj";
        if (!is_obj && extension != ".ply") {
            throw file_error(
                ErrorCode::unsupported, file.string(),
                fmt::format("cannot write {} files, only .obj and .ply", in_quotes(extension)));
        }
        check_is_writable(mesh, is_obj, file.string());
        NewFile output(file);
        if (is_obj) {
            write_obj(mesh, output);
        } else {
            write_ply(mesh, output);
        }
        output.commit();
    });
}

}  // namespace coppice::inline v0
