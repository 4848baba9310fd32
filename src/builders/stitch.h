// Assembles a tree from parts that tasks built in arrays of their own. The place of a part in the
// whole is known only when all parts are done. Inserting parts into their parents level by level
// would copy a node once for every task above it. Instead, the place of every part is computed
// first, depth first. Then each part is copied once, all in parallel.
#pragma once

#include "coppice/base/parallel.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace coppice::inline v0 {

/// The place of a part in the arrays of the whole tree: of its root, of its other nodes, which are
/// contiguous, and of its items (references of a k-d tree, blocks of an 8-wide tree).
struct PartPlace {
    std::uint64_t root;
    std::uint64_t below;
    std::uint64_t items;
};

/// The order of the roots of the parts that hang below a part.
enum class LinkedRoots {
    together,  ///< side by side, followed by the rest of the first part, the second ...
    apart      ///< each directly before the rest of its part
};

/// Computes the places of a part and all parts below it. A Part has own_node_count(), which
/// includes its root, own_item_count(), link_count(), and link(i), the parts that hang below it.
template <typename Part, LinkedRoots linked_roots>
class Placement {
public:
    struct Placed {
        Part* part;
        PartPlace place;
        std::vector<std::uint64_t> link_roots;
    };

    /// Computes the places of `root` and all parts below it; `root` must outlive this object.
    explicit Placement(Part& root) { add(root, 0); }

    [[nodiscard]] std::uint64_t node_count() const noexcept { return node_count_; }

    [[nodiscard]] std::uint64_t item_count() const noexcept { return item_count_; }

    /// Calls copy(placed) for every part, in parallel.
    template <typename Copy>
    void for_each(Copy&& copy) const {
        parallel_for_chunks(parts_.size(), 1,
                            [&](std::size_t at, std::size_t /*end*/) { copy(parts_[at]); });
    }

private:
    void add(Part& part, std::uint64_t root) {
        const std::size_t at = parts_.size();
        parts_.push_back({&part, {root, node_count_, item_count_}, {}});
        node_count_ += part.own_node_count() - 1;
        item_count_ += part.own_item_count();
        const std::size_t link_count = part.link_count();
        std::vector<std::uint64_t> roots;
        for (std::size_t i = 0; i < link_count; ++i) {
            roots.push_back(node_count_++);
            if (linked_roots == LinkedRoots::apart) add(part.link(i), roots[i]);
        }
        for (std::size_t i = 0; linked_roots == LinkedRoots::together && i < link_count; ++i) {
            add(part.link(i), roots[i]);
        }
        parts_[at].link_roots = std::move(roots);
    }

    std::vector<Placed> parts_;
    std::uint64_t node_count_ = 1;  // index 0 is the root
    std::uint64_t item_count_ = 0;
};

}  // namespace coppice::inline v0
