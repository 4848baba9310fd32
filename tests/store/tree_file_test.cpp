// The tree file: what is saved comes back and traces the same; what is not exactly that is refused,
// in words that say why.

#include "coppice/store/tree_file.h"

#include "coppice/builders/build_tree.h"
#include "coppice/query/mesh_search.h"
#include "coppice/trace/bvh8_tracer.h"
#include "coppice/tree/validate.h"

#include "io/test_files.h"
#include "store/checksum.h"
#include "store/tree_file_header.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>

namespace coppice::test {
namespace {

const TreeOrigin origin{"fast", R"({"a": 1})"};

std::string saved_bvh8(const TriangleMesh& mesh) {
    const std::filesystem::path file = fresh_folder() / "tree.cpk";
    save_tree(file, build_bvh8(mesh.view(), {}).tree, fingerprint_of(mesh.view()), origin);
    return read_file(file);
}

std::string saved_kd(const TriangleMesh& mesh) {
    const std::filesystem::path file = fresh_folder() / "tree.cpk";
    save_tree(file, build_kd_tree(mesh.view(), {}).tree, fingerprint_of(mesh.view()));
    return read_file(file);
}

/// What load_tree says about a file of these bytes, without the folder; "" if it loads it.
std::string error_of_tree(const std::string& bytes, ErrorCode expected = ErrorCode::parse) {
    const std::filesystem::path file = make_file("tree.cpk", bytes);
    std::string what;
    try {
        static_cast<void>(load_tree(file));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), expected) << error.what();
        what = std::string(error.what()).substr(file.parent_path().string().size() + 1);
    }
    std::filesystem::remove_all(file.parent_path());
    return what;
}

/// The header of a file, to be read or changed.
TreeFileHeader header_of(const std::string& bytes) {
    TreeFileHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    return header;
}

std::uint64_t checksum_of(const std::string& bytes, std::size_t first, std::size_t count) {
    return checksum(std::as_bytes(std::span(bytes).subspan(first, count)));
}

/// A file with another header, and all checksums as a forger would set them.
std::string forged(std::string bytes, TreeFileHeader header) {
    const std::size_t nodes = header.node_count * header.node_bytes;
    const std::size_t items = header.item_count * header.item_bytes;
    if (sizeof header + nodes + items <= bytes.size()) {
        header.node_checksum = checksum_of(bytes, sizeof header, nodes);
        header.item_checksum = checksum_of(bytes, sizeof header + nodes, items);
    }
    std::memcpy(bytes.data(), &header, sizeof header);
    header.header_checksum = checksum_of(bytes, 0, offsetof(TreeFileHeader, header_checksum));
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

/// Changes one node, reference or block of a file, and its checksums.
template <typename Element>
std::string with_changed(std::string bytes, std::size_t offset,
                         const std::function<void(Element&)>& change) {
    Element element;
    std::memcpy(static_cast<void*>(&element), bytes.data() + offset, sizeof element);
    change(element);
    std::memcpy(bytes.data() + offset, &element, sizeof element);
    return forged(bytes, header_of(bytes));
}

TEST(TreeFile, ABvh8ComesBackAndTracesTheSame) {
    const TriangleMesh mesh = make_soup(3000, 0.1F, 1);
    const std::filesystem::path file = fresh_folder() / "tree.cpk";
    const Bvh8 tree = build_bvh8(mesh.view(), {}).tree;
    save_tree(file, tree, fingerprint_of(mesh.view()), origin);
    const SavedTree saved = load_tree(file, fingerprint_of(mesh.view()));
    EXPECT_EQ(saved.origin, origin);
    EXPECT_EQ(saved.primitives.primitive_count, 3000U);
    EXPECT_EQ(saved.file_bytes, std::filesystem::file_size(file));
    std::filesystem::remove(file);  // what is mapped stays
    const auto& loaded = std::get<Bvh8>(saved.tree);
    EXPECT_EQ(loaded.bounds(), tree.bounds());
    EXPECT_TRUE(validate(loaded, mesh.view()).empty());
    const Bvh8Tracer before(tree);
    const Bvh8Tracer after(loaded);
    for (int i = 0; i < 1000; ++i) {
        const float x = static_cast<float>(i) / 1000.0F;
        const Ray ray{.origin = {x, 1.0F - x, -1.0F}, .direction = {0.1F, 0.2F, 1.0F}};
        const auto hit = before.intersect(ray);
        const auto again = after.intersect(ray);
        ASSERT_EQ(hit.has_value(), again.has_value());
        if (hit) {
            EXPECT_TRUE(hit->t == again->t && hit->prim == again->prim);
        }
    }
    EXPECT_EQ(MeshSearch(loaded).nearest({0.5F, 0.5F, 0.5F}).prim,
              MeshSearch(tree).nearest({0.5F, 0.5F, 0.5F}).prim);
}

TEST(TreeFile, AKdTreeComesBackEqualAndCanBeEmptied) {
    const TriangleMesh mesh = make_terrain(20, 1);
    const std::filesystem::path file = fresh_folder() / "tree.cpk";
    const KdTree tree = build_kd_tree(mesh.view(), {}).tree;
    save_tree(file, tree, fingerprint_of(mesh.view()));
    SavedTree saved = load_tree(file, fingerprint_of(mesh.view()));
    auto& loaded = std::get<KdTree>(saved.tree);
    EXPECT_TRUE(loaded == tree);
    const Skeleton of_file(std::move(loaded));
    const Skeleton of_tree(KdTree{tree});
    EXPECT_TRUE(std::ranges::equal(of_file.nodes(), of_tree.nodes()));
}

TEST(TreeFile, TreesOfNothingAndOfPointsComeBack) {
    const std::filesystem::path file = fresh_folder() / "tree.cpk";
    save_tree(file, Bvh8(), fingerprint_of(TriangleMeshView()));
    EXPECT_EQ(std::get<Bvh8>(load_tree(file).tree).nodes().size(), 1U);
    save_tree(file, KdTree(), fingerprint_of(TriangleMeshView()));
    EXPECT_TRUE(std::get<KdTree>(load_tree(file).tree) == KdTree());
    const std::vector<Vec3f> points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    const PointCloudView view{points};
    const KdTree tree = build_kd_tree(view, {}).tree;
    save_tree(file, tree, fingerprint_of(view));
    EXPECT_TRUE(std::get<KdTree>(load_tree(file, fingerprint_of(view)).tree) == tree);
}

TEST(TreeFile, AnotherMeshIsRefused) {
    const TriangleMesh mesh = make_soup(100, 0.1F, 1);
    const std::filesystem::path file = make_file("tree.cpk", saved_bvh8(mesh));
    const auto error_for = [&](const TriangleMesh& other) {
        try {
            static_cast<void>(load_tree(file, fingerprint_of(other.view())));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
            return std::string(error.what()).substr(file.string().size());
        }
        return std::string();
    };
    EXPECT_EQ(error_for(mesh), "");
    EXPECT_EQ(error_for(make_soup(7, 0.1F, 1)), ": built for another mesh: 100 primitives, not 7");
    TriangleMesh other = mesh;
    other.vertices.push_back({});
    EXPECT_EQ(error_for(other), ": built for another mesh: 300 vertices, not 301");
    other = mesh;
    other.vertices.back().z = std::nextafter(other.vertices.back().z, 2.0F);
    EXPECT_EQ(error_for(other), ": built for another mesh: its vertex positions differ");
    other = mesh;
    std::swap(other.triangles[1], other.triangles[2]);
    EXPECT_EQ(error_for(other), ": built for another mesh: its vertex indices differ");
}

TEST(TreeFile, AnythingElseIsNoTreeFile) {
    EXPECT_EQ(error_of_tree(""), "tree.cpk: empty file");
    for (const std::string& bytes :
         {std::string("v 0 0 0\n"), std::string("x"), std::string(1000, '\0')}) {
        EXPECT_EQ(error_of_tree(bytes), "tree.cpk: not a coppice tree file");
    }
}

TEST(TreeFile, OtherVersionsByteOrdersAndLayoutsAreRefused) {
    const std::string bytes = saved_bvh8(make_soup(10, 0.1F, 1));
    TreeFileHeader header = header_of(bytes);
    header.version = 2;
    EXPECT_EQ(error_of_tree(forged(bytes, header), ErrorCode::unsupported),
              "tree.cpk: format version 2, but this program reads version 1: build the tree "
              "again");
    header = header_of(bytes);
    header.byte_order = TreeFileHeader::other_byte_order;
    EXPECT_EQ(error_of_tree(forged(bytes, header), ErrorCode::unsupported),
              "tree.cpk: written with another byte order: build the tree on this machine");
    header = header_of(bytes);
    header.node_bytes = 128;
    EXPECT_EQ(
        error_of_tree(forged(bytes, header), ErrorCode::unsupported),
        "tree.cpk: unsupported layout: kind 1, a header of 192 bytes, nodes of 128 and blocks of "
        "320");
    header = header_of(bytes);
    header.kind = 7;
    EXPECT_NE(error_of_tree(forged(bytes, header), ErrorCode::unsupported), "");
}

TEST(TreeFile, EveryTruncationIsRefused) {
    const std::string bytes = saved_kd(make_soup(10, 0.1F, 1));
    EXPECT_EQ(error_of_tree(bytes), "");
    for (std::size_t size = 8; size < bytes.size(); ++size) {
        const std::string error = error_of_tree(bytes.substr(0, size));
        ASSERT_TRUE(error.starts_with("tree.cpk: truncated: ")) << size << ": " << error;
    }
    EXPECT_EQ(error_of_tree(bytes + "x"),
              "tree.cpk: damaged: 1 bytes after the end at byte " + std::to_string(bytes.size()));
}

TEST(TreeFile, EveryFlippedBitIsFound) {
    const TriangleMesh mesh = make_soup(9, 0.1F, 1);
    for (const std::string& bytes : {saved_bvh8(mesh), saved_kd(mesh)}) {
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            std::string flipped = bytes;
            flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
            const std::filesystem::path file = make_file("tree.cpk", flipped);
            EXPECT_THROW(static_cast<void>(load_tree(file)), Error) << at;
            std::filesystem::remove_all(file.parent_path());
        }
    }
}

TEST(TreeFile, AForgedSizeIsRefused) {
    const std::string bytes = saved_kd(make_soup(10, 0.1F, 1));
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    for (auto count : {&TreeFileHeader::node_count, &TreeFileHeader::item_count,
                       &TreeFileHeader::method_bytes, &TreeFileHeader::options_bytes}) {
        for (const std::uint64_t value : {most, most / 8 + 1, std::uint64_t{1} << 39}) {
            TreeFileHeader header = header_of(bytes);
            header.*count = value;
            EXPECT_NE(error_of_tree(forged(bytes, header)), "");
        }
    }
}

// With a bound of NaN a search for what is nearest took empty slots for near (found by fuzzing).
TEST(TreeFile, ForgedBoundsAreRefused) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const std::string& bytes :
         {saved_kd(make_terrain(8, 1)), saved_bvh8(make_terrain(8, 1))}) {
        for (const float bound : {std::numeric_limits<float>::quiet_NaN(), infinity, 1e30F}) {
            TreeFileHeader header = header_of(bytes);
            header.bounds[1] = bound;
            EXPECT_EQ(error_of_tree(forged(bytes, header)),
                      "tree.cpk: invalid tree: its bounds are not a finite box");
        }
    }
}

TEST(TreeFile, AForgedKdTreeCannotLeadOutOfItsArrays) {
    const std::string bytes = saved_kd(make_terrain(8, 1));
    const TreeFileHeader header = header_of(bytes);
    const std::size_t root = sizeof header;
    const std::size_t references = root + header.node_count * sizeof(KdNode);
    const auto error_with_root = [&](KdNode node) {
        return error_of_tree(with_changed<KdNode>(bytes, root, [&](KdNode& at) { at = node; }));
    };
    const auto count = static_cast<std::uint32_t>(header.node_count);
    const std::string start = "tree.cpk: invalid tree: ";
    EXPECT_EQ(error_with_root(KdNode::make_inner({}, PlanarSide::below, count - 1)),
              start + "node 0 has the child " + std::to_string(count) + " of " +
                  std::to_string(count) +
                  " nodes: out of range, not after its parent, or already used by another node");
    EXPECT_NE(error_with_root(KdNode::make_inner({}, PlanarSide::below, 0)), "");
    EXPECT_NE(error_with_root(KdNode::make_inner({}, PlanarSide::below, 3)), "");
    EXPECT_NE(error_with_root(KdNode::make_leaf(0, KdNode::max_payload)), "");
    EXPECT_NE(error_with_root(KdNode::make_leaf(0xffffffff, 1)), "");
    EXPECT_EQ(error_of_tree(with_changed<std::uint32_t>(bytes, references,
                                                        [](std::uint32_t& id) { id = 128; })),
              start + "reference 0 is to primitive 128, but there are 128 primitives");
}

TEST(TreeFile, ATreeTooDeepIsRefused) {
    std::vector<KdNode> nodes;
    for (std::uint32_t depth = 0; depth <= KdTree::max_depth; ++depth) {
        if (depth > 0) nodes.emplace_back();  // the inner node's sibling, below its plane
        nodes.push_back(KdNode::make_inner({Axis::x, 0.5F}, PlanarSide::below, 2 * depth + 1));
    }
    nodes.resize(nodes.size() + 2);
    const std::filesystem::path file = fresh_folder() / "tree.cpk";
    save_tree(file, KdTree(nodes, {}, Aabb{{0, 0, 0}, {1, 1, 1}}), {});
    EXPECT_EQ(error_of_tree(read_file(file)),
              "tree.cpk: invalid tree: node 121 is more than 60 levels deep");
}

TEST(TreeFile, AForgedBvh8CannotLeadOutOfItsArrays) {
    const std::string bytes = saved_bvh8(make_terrain(24, 1));
    const TreeFileHeader header = header_of(bytes);
    ASSERT_GT(header.node_count, 2U);
    const auto count = static_cast<std::uint32_t>(header.node_count);
    const std::size_t root = sizeof header;
    const std::size_t blocks = root + count * sizeof(Bvh8Node);
    const auto error_with_child = [&](Bvh8Child child) {
        return error_of_tree(
            with_changed<Bvh8Node>(bytes, root, [&](Bvh8Node& node) { node.child[0] = child; }));
    };
    const auto error_with_block = [&](const std::function<void(TriangleBlock&)>& change) {
        return error_of_tree(with_changed<TriangleBlock>(bytes, blocks, change));
    };
    EXPECT_EQ(error_with_child(Bvh8Child::make_inner(count)),
              "tree.cpk: invalid tree: node 0 has the child " + std::to_string(count) + " of " +
                  std::to_string(count) +
                  " nodes: out of range, not after its parent, or already used by another node");
    EXPECT_NE(error_with_child(Bvh8Child::make_inner(0)), "");
    EXPECT_NE(error_with_child(Bvh8Child::make_inner(count - 1)), "");
    EXPECT_NE(error_with_child(
                  Bvh8Child::make_leaf(static_cast<std::uint32_t>(header.item_count) - 1, 2)),
              "");
    EXPECT_NE(error_with_child(Bvh8Child::make_empty()), "");
    EXPECT_NE(error_with_block([](TriangleBlock& block) { block.id[0] = 2 * 24 * 24; }), "");
    EXPECT_NE(error_with_block([](TriangleBlock& block) {
                  block.id[7] = TriangleBlock::no_triangle;
                  block.corner[0][0][7] = 0.0F;
              }),
              "");
    EXPECT_NE(error_with_block([](TriangleBlock& block) {
                  block.id[0] = TriangleBlock::no_triangle;
                  block.corner[0][0][0] = std::numeric_limits<float>::quiet_NaN();
                  block.id[1] = 1;
              }),
              "");
}

TEST(TreeFile, IsWrittenWholeOrNotAtAll) {
    const std::filesystem::path folder = fresh_folder();
    const TriangleMesh mesh = make_soup(10, 0.1F, 1);
    const Bvh8 tree = build_bvh8(mesh.view(), {}).tree;
    for (const std::filesystem::path& file :
         {folder / "none" / "tree.cpk", folder, std::filesystem::path("/dev/full")}) {
        EXPECT_THROW(save_tree(file, tree, fingerprint_of(mesh.view())), Error) << file;
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    save_tree(folder / "\xff.cpk", tree, fingerprint_of(mesh.view()));  // no UTF-8
    EXPECT_NO_THROW(static_cast<void>(load_tree(folder / "\xff.cpk")));
}

}  // namespace
}  // namespace coppice::test
