#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/tree/kd_node.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// An immutable k-d tree: nodes, the references of its leaves, and a bounding box. It does not know
/// the primitives; references are ids into the set that the tree was built for.
///
/// Order: node 0 is the root, and siblings are adjacent. A pair of siblings is followed by all
/// nodes below the lower sibling, then by all nodes below the upper one, so that children follow
/// their parents. References are stored leaf by leaf in depth-first order, ascending within a leaf.
/// Copies share their arrays.
class COPPICE_EXPORT KdTree {
public:
    /// The greatest depth of a leaf; the root has depth 0. The limit lets traversals use a stack of
    /// fixed size.
    static constexpr int max_depth = 60;

    /// A tree over no primitives: one empty leaf with an empty bounding box.
    KdTree() noexcept;

    /// Takes ownership of arrays in the order described above. Throws Error(invalid_argument) if
    /// `nodes` is empty; validate() checks everything else.
    KdTree(std::vector<KdNode> nodes, std::vector<std::uint32_t> references, const Aabb& bounds);

    /// A tree that refers to arrays which `storage` keeps alive, such as those of a mapped file.
    /// Same order, same errors.
    KdTree(std::shared_ptr<const void> storage, std::span<const KdNode> nodes,
           std::span<const std::uint32_t> references, const Aabb& bounds);

    /// All nodes in the order described above.
    [[nodiscard]] std::span<const KdNode> nodes() const noexcept { return nodes_; }

    /// The root node, the first of nodes().
    [[nodiscard]] const KdNode& root() const noexcept { return nodes_.front(); }

    /// The references of all leaves.
    [[nodiscard]] std::span<const std::uint32_t> references() const noexcept { return references_; }

    /// The primitive ids in one leaf of this tree.
    [[nodiscard]] std::span<const std::uint32_t> references(const KdNode& leaf) const noexcept {
        return references().subspan(leaf.first_reference(), leaf.reference_count());
    }

    /// The box that the planes divide.
    [[nodiscard]] const Aabb& bounds() const noexcept { return bounds_; }

    /// The size of nodes and references in bytes.
    [[nodiscard]] std::uint64_t byte_count() const noexcept {
        return nodes_.size_bytes() + references_.size_bytes();
    }

    /// True if both trees have equal arrays and boxes.
    friend bool operator==(const KdTree& a, const KdTree& b) noexcept;

private:
    friend class Skeleton;

    struct Arrays {
        std::vector<KdNode> nodes;
        std::vector<std::uint32_t> references;
    };

    KdTree(std::shared_ptr<Arrays> arrays, const Aabb& bounds);

    /// Moves the nodes out, or copies them if another tree shares them. Leaves a tree over no
    /// primitives.
    [[nodiscard]] std::vector<KdNode> release_nodes();

    std::shared_ptr<Arrays> arrays_;       // null if the arrays are in storage_, or static
    std::shared_ptr<const void> storage_;  // null if they are not
    std::span<const KdNode> nodes_;
    std::span<const std::uint32_t> references_;
    Aabb bounds_;
};

/// A k-d tree whose leaves have been emptied: it has planes, but no references. Made by
/// empty_leaves() and filled again by refill().
class COPPICE_EXPORT Skeleton {
public:
    /// Empties the leaves of a tree and frees its references.
    explicit Skeleton(KdTree&& tree);

    /// All nodes. No leaf has references, and each leaf records whether it had any
    /// (KdNode::in_sample).
    [[nodiscard]] std::span<const KdNode> nodes() const noexcept { return nodes_; }

    /// The box that the planes divide.
    [[nodiscard]] const Aabb& bounds() const noexcept { return bounds_; }

    /// Moves the nodes out, for a refill in place. The skeleton is left without nodes.
    [[nodiscard]] std::vector<KdNode> release_nodes() && noexcept { return std::move(nodes_); }

private:
    std::vector<KdNode> nodes_;
    Aabb bounds_;
};

}  // namespace coppice::inline v0
