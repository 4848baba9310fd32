// The tree file: damaged files, and forged ones whose checksums are right. What is loaded takes any
// query without leaving its arrays; whether it finds the truth is not asked of a forged tree.

#include "coppice/store/tree_file.h"

#include "coppice/base/error.h"
#include "coppice/query/mesh_search.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/trace/intersect.h"
#include "coppice/tree/validate.h"

#include "expect.h"
#include "rays.h"
#include "scratch_file.h"
#include "store/checksum.h"
#include "store/tree_file_header.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <variant>

namespace coppice::fuzz {
namespace {

std::uint64_t checksum_of(std::string_view bytes) {
    return checksum(std::as_bytes(std::span(bytes)));
}

/// A header for `body` with the counts that `data` says, and all checksums right as far as the body
/// reaches.
std::string forged(FuzzedDataProvider& data, std::string body) {
    TreeFileHeader header;
    header.kind = data.ConsumeIntegralInRange<std::uint32_t>(0, 1);
    const bool is_kd = header.kind == TreeFileHeader::kd;
    header.node_bytes = is_kd ? sizeof(KdNode) : sizeof(Bvh8Node);
    header.item_bytes = is_kd ? sizeof(std::uint32_t) : sizeof(TriangleBlock);
    header.node_count = data.ConsumeIntegralInRange<std::uint64_t>(1, 64);
    header.item_count = data.ConsumeIntegralInRange<std::uint64_t>(0, 64);
    header.method_bytes = data.ConsumeIntegralInRange<std::uint64_t>(0, 8);
    header.options_bytes = data.ConsumeIntegralInRange<std::uint64_t>(0, 8);
    header.primitives.primitive_count = data.ConsumeIntegralInRange<std::uint64_t>(0, 64);
    for (float& bound : header.bounds) {
        bound = take_float(data);
    }
    const std::size_t nodes = header.node_count * header.node_bytes;
    const std::size_t items = header.item_count * header.item_bytes;
    const std::size_t texts = header.method_bytes + header.options_bytes;
    body.resize(nodes + items + texts);
    const std::string_view view = body;
    header.node_checksum = checksum_of(view.substr(0, nodes));
    header.item_checksum = checksum_of(view.substr(nodes, items));
    header.text_checksum = checksum_of(view.substr(nodes + items));
    std::string bytes(sizeof header, '\0');
    std::memcpy(bytes.data(), &header, sizeof header);
    header.header_checksum =
        checksum_of(std::string_view(bytes).substr(0, offsetof(TreeFileHeader, header_checksum)));
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes + body;
}

/// As many triangles as the tree says it was built for.
TriangleMesh make_mesh(std::uint64_t triangle_count) {
    TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5F}, {1, 1, 1}}};
    for (std::uint64_t i = 0; i < triangle_count; ++i) {
        const auto corner = static_cast<std::uint32_t>(i % 4);
        mesh.triangles.push_back({corner, (corner + 1) % 4, (corner + 2) % 4});
    }
    return mesh;
}

void query(const KdTree& tree, TriangleMeshView mesh, const Ray& ray) {
    std::array<Hit, 3> hits;
    static_cast<void>(intersect(tree, mesh, ray));
    static_cast<void>(occluded(tree, mesh, ray));
    static_cast<void>(intersect_all(tree, mesh, ray, hits));
    static_cast<void>(count_hits(tree, mesh, ray));
}

void query(const Bvh8& tree, TriangleMeshView /*mesh*/, const Ray& ray) {
    std::array<Hit, 3> hits;
    for (const Isa isa : available_isas()) {
        const Bvh8Tracer tracer(tree, isa);
        static_cast<void>(tracer.intersect(ray));
        static_cast<void>(tracer.occluded(ray));
        static_cast<void>(tracer.intersect_all(ray, hits));
        static_cast<void>(tracer.count_hits(ray));
    }
    const MeshSearch search(tree);
    const auto ignore = [](auto&&) {};
    static_cast<void>(search.nearest(ray.origin));
    search.for_each_within(ray.origin, ray.t_max, ignore);
    search.for_each_overlapping({ray.origin, ray.direction}, ignore);
}

void use(FuzzedDataProvider& data, const SavedTree& saved) {
    if (saved.primitives.primitive_count > 4096) return;  // a mesh of so many takes too long
    const TriangleMesh mesh = make_mesh(saved.primitives.primitive_count);
    std::visit(
        [&](const auto& tree) {
            static_cast<void>(validate(tree, mesh.view(), 20));
            for (int i = 0; i < 4; ++i) {
                query(tree, mesh.view(), take_ray(data, mesh.view()));
            }
        },
        saved.tree);
}

void run(FuzzedDataProvider& data) {
    const bool is_forged = data.ConsumeBool();
    std::string bytes;
    if (is_forged) {
        const auto size = data.ConsumeIntegralInRange<std::size_t>(0, data.remaining_bytes());
        bytes = forged(data, data.ConsumeBytesAsString(size));
    } else {
        bytes = data.ConsumeRemainingBytesAsString();
    }
    const auto file = scratch_folder().write("tree.cpk", bytes);
    try {
        use(data, load_tree(file));
    } catch (const Error& error) {
        expect(std::string_view(error.what()).starts_with(file.string()), "the file in the error");
    }
}

}  // namespace
}  // namespace coppice::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider provider(data, size);
    coppice::fuzz::run(provider);
    return 0;
}
