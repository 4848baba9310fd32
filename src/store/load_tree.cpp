// Loading trusts nothing in the file. Checks, in this order:
// - magic, byte order and version, which every version has at the same offsets;
// - the header's checksum, after which its counts are known to be what was written;
// - the layout, and the file size that follows from it;
// - the checksums of all sections;
// - every index that a query follows (structure.h), because a forged file can have valid checksums.
//
// Only the header is copied; the arrays stay where they are mapped.
//
// Cost: two passes over the file at memory speed, in parallel.

#include "coppice/base/error.h"
#include "coppice/store/tree_file.h"

#include "base/out_of_memory.h"
#include "store/checksum.h"
#include "store/mapped_file.h"
#include "store/structure.h"
#include "store/tree_file_header.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string_view>

namespace coppice::inline v0 {
namespace {

class TreeFile {
public:
    explicit TreeFile(const std::filesystem::path& file)
        : name_(file.string()), mapped_(std::make_shared<const MappedFile>(file)) {
        read_header();
        check_layout();
        check_size();
    }

    [[nodiscard]] const TreeFileHeader& header() const noexcept { return header_; }

    /// Verifies the checksums of all sections but the header, and returns the tree.
    [[nodiscard]] AnyTree tree() const {
        verify(0, node_size(), header_.node_checksum, "nodes");
        verify(node_size(), item_size(), header_.item_checksum, item_name());
        verify(node_size() + item_size(), text_size(), header_.text_checksum, "options");
        const auto& box = header_.bounds;
        const Aabb bounds{{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
        if (header_.kind == TreeFileHeader::kd) {
            return checked(KdTree(mapped_, nodes<KdNode>(), items<std::uint32_t>(), bounds));
        }
        return checked(Bvh8(mapped_, nodes<Bvh8Node>(), items<TriangleBlock>(), bounds));
    }

    [[nodiscard]] TreeOrigin origin() const {
        const auto at = section(node_size() + item_size(), text_size());
        const std::string_view text(reinterpret_cast<const char*>(at.data()), at.size());
        return {std::string(text.substr(0, header_.method_bytes)),
                std::string(text.substr(header_.method_bytes))};
    }

    [[nodiscard]] std::uint64_t byte_count() const noexcept { return mapped_->bytes().size(); }

    [[noreturn]] void fail(ErrorCode code, std::string_view what) const {
        throw file_error(code, name_, what);
    }

private:
    void read_header() {
        const auto bytes = mapped_->bytes();
        const std::size_t there = std::min(bytes.size(), sizeof header_);
        std::memcpy(&header_, bytes.data(), there);
        if (there < header_.magic.size() || header_.magic != TreeFileHeader::own_magic) {
            fail(ErrorCode::parse, "not a coppice tree file");
        }
        if (there < sizeof header_) {
            fail(ErrorCode::parse,
                 fmt::format("truncated: {} of the header's {} bytes", there, sizeof header_));
        }
        if (header_.byte_order == TreeFileHeader::other_byte_order) {
            fail(ErrorCode::unsupported,
                 "written with another byte order: build the tree on this machine");
        }
        if (header_.byte_order != TreeFileHeader::own_byte_order) {
            fail(ErrorCode::parse, "damaged: invalid byte-order mark");
        }
        if (header_.version != TreeFileHeader::own_version) {
            fail(ErrorCode::unsupported,
                 fmt::format("format version {}, but this program reads version {}: build the "
                             "tree again",
                             header_.version, TreeFileHeader::own_version));
        }
        const std::size_t checked_size = offsetof(TreeFileHeader, header_checksum);
        if (checksum(bytes.first(checked_size)) != header_.header_checksum) {
            fail(ErrorCode::parse, "damaged: the checksum of the header is wrong");
        }
    }

    void check_layout() const {
        const bool is_kd = header_.kind == TreeFileHeader::kd;
        const std::size_t node = is_kd ? sizeof(KdNode) : sizeof(Bvh8Node);
        const std::size_t item = is_kd ? sizeof(std::uint32_t) : sizeof(TriangleBlock);
        const bool is_ours = header_.kind <= TreeFileHeader::bvh8 &&
                             header_.header_bytes == sizeof header_ && header_.node_bytes == node &&
                             header_.item_bytes == item;
        if (is_ours) return;
        fail(ErrorCode::unsupported,
             fmt::format(
                 "unsupported layout: kind {}, a header of {} bytes, nodes of {} and {} of {}",
                 header_.kind, header_.header_bytes, header_.node_bytes, item_name(),
                 header_.item_bytes));
    }

    void check_size() const {
        // Upper limits of plausible counts. Their sum does not overflow.
        constexpr std::uint64_t most_text = std::uint64_t{1} << 32;
        constexpr std::uint64_t most_items = std::uint64_t{1} << 40;
        const bool is_possible =
            header_.node_count >= 1 && header_.node_count <= most_items &&
            header_.item_count <= most_items && header_.method_bytes <= most_text &&
            header_.options_bytes <= most_text &&
            header_.primitives.primitive_count <= std::numeric_limits<std::uint32_t>::max();
        if (!is_possible) {
            fail(ErrorCode::parse,
                 fmt::format("damaged: impossible counts of {} nodes, {} {}, {} primitives",
                             header_.node_count, header_.item_count, item_name(),
                             header_.primitives.primitive_count));
        }
        const std::uint64_t wanted = sizeof header_ + node_size() + item_size() + text_size();
        if (byte_count() < wanted) {
            fail(ErrorCode::parse, fmt::format("truncated: {} of {} bytes", byte_count(), wanted));
        }
        if (byte_count() > wanted) {
            fail(ErrorCode::parse, fmt::format("damaged: {} bytes after the end at byte {}",
                                               byte_count() - wanted, wanted));
        }
    }

    void verify(std::uint64_t offset, std::uint64_t size, std::uint64_t expected,
                std::string_view what) const {
        if (checksum(section(offset, size)) == expected) return;
        fail(ErrorCode::parse, fmt::format("damaged: the checksum of the {} is wrong", what));
    }

    template <typename Tree>
    [[nodiscard]] Tree checked(Tree tree) const {
        const std::string flaw =
            find_flaw(tree, static_cast<std::uint32_t>(header_.primitives.primitive_count));
        if (!flaw.empty()) fail(ErrorCode::parse, "invalid tree: " + flaw);
        return tree;
    }

    [[nodiscard]] std::uint64_t node_size() const noexcept {
        return header_.node_count * header_.node_bytes;
    }

    [[nodiscard]] std::uint64_t item_size() const noexcept {
        return header_.item_count * header_.item_bytes;
    }

    [[nodiscard]] std::uint64_t text_size() const noexcept {
        return header_.method_bytes + header_.options_bytes;
    }

    [[nodiscard]] const char* item_name() const noexcept {
        return header_.kind == TreeFileHeader::kd ? "references" : "blocks";
    }

    /// The section of the file at `offset` bytes after the header.
    [[nodiscard]] std::span<const std::byte> section(std::uint64_t offset,
                                                     std::uint64_t size) const noexcept {
        return mapped_->bytes().subspan(sizeof header_ + offset, size);
    }

    template <typename Node>
    [[nodiscard]] std::span<const Node> nodes() const noexcept {
        return {reinterpret_cast<const Node*>(section(0, node_size()).data()), header_.node_count};
    }

    template <typename Item>
    [[nodiscard]] std::span<const Item> items() const noexcept {
        return {reinterpret_cast<const Item*>(section(node_size(), item_size()).data()),
                header_.item_count};
    }

    std::string name_;
    std::shared_ptr<const MappedFile> mapped_;
    TreeFileHeader header_;
};

SavedTree read(const TreeFile& file) {
    const TreeFileHeader& header = file.header();
    return {file.tree(), header.primitives, file.origin(), file.byte_count(), header.version};
}

}  // namespace

SavedTree load_tree(const std::filesystem::path& file) {
    return with_memory_errors(file, [&] { return read(TreeFile(file)); });
}

SavedTree load_tree(const std::filesystem::path& file, const Fingerprint& primitives) {
    return with_memory_errors(file, [&] {
        const TreeFile opened(file);
        const std::string other = difference(opened.header().primitives, primitives);
        if (!other.empty()) {
            opened.fail(ErrorCode::invalid_argument, "built for another mesh: " + other);
        }
        return read(opened);
    });
}

}  // namespace coppice::inline v0
