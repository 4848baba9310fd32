#include "coppice/store/tree_file.h"

#include "base/out_of_memory.h"
#include "io/new_file.h"
#include "store/checksum.h"
#include "store/tree_file_header.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace coppice::inline v0 {
namespace {

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <typename Node, typename Item>
void save(const std::filesystem::path& file, std::span<const Node> nodes,
          std::span<const Item> items, const TreeOrigin& origin, TreeFileHeader header) {
    NewFile output(file);  // fails early if the file cannot be written
    const std::string text = origin.method + origin.options;
    header.node_bytes = sizeof(Node);
    header.item_bytes = sizeof(Item);
    header.node_count = nodes.size();
    header.item_count = items.size();
    header.method_bytes = origin.method.size();
    header.options_bytes = origin.options.size();
    header.node_checksum = checksum(std::as_bytes(nodes));
    header.item_checksum = checksum(std::as_bytes(items));
    header.text_checksum = checksum(std::as_bytes(std::span(text)));
    const auto bytes = std::as_bytes(std::span(&header, 1));
    header.header_checksum = checksum(bytes.first(offsetof(TreeFileHeader, header_checksum)));
    output.write(as_text(bytes));
    output.write(as_text(std::as_bytes(nodes)));
    output.write(as_text(std::as_bytes(items)));
    output.write(text);
    output.sync();
    output.commit();
}

TreeFileHeader make_header(TreeFileHeader::Kind kind, const Fingerprint& primitives,
                           const Aabb& box) {
    TreeFileHeader header;
    header.kind = kind;
    header.primitives = primitives;
    header.bounds = {box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z};
    return header;
}

}  // namespace

void save_tree(const std::filesystem::path& file, const KdTree& tree, const Fingerprint& primitives,
               const TreeOrigin& origin) {
    with_memory_errors(file, [&] {
        save(file, tree.nodes(), tree.references(), origin,
             make_header(TreeFileHeader::kd, primitives, tree.bounds()));
    });
}

void save_tree(const std::filesystem::path& file, const Bvh8& tree, const Fingerprint& primitives,
               const TreeOrigin& origin) {
    with_memory_errors(file, [&] {
        save(file, tree.nodes(), tree.blocks(), origin,
             make_header(TreeFileHeader::bvh8, primitives, tree.bounds()));
    });
}

}  // namespace coppice::inline v0
