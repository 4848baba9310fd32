#pragma once

#include "coppice/export.h"
#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace coppice::inline v0 {

/// The number of children of an 8-wide node, and of triangles in a leaf block.
inline constexpr std::size_t bvh8_width = 8;

/// The content of one slot of an 8-wide node: nothing, an inner node, or a leaf of one or more
/// blocks. A default-constructed object is uninitialized, because traversals have stacks of them;
/// use the factories.
class Bvh8Child {
public:
    /// The greatest index of an inner node.
    static constexpr std::uint32_t max_node_index = (1U << 31) - 2;
    /// The greatest index of a leaf's first block.
    static constexpr std::uint32_t max_block_index = (1U << 27) - 1;
    /// The greatest number of blocks of a leaf.
    static constexpr std::uint32_t max_block_count = 16;

    Bvh8Child() = default;

    /// An empty slot.
    [[nodiscard]] static constexpr Bvh8Child make_empty() noexcept { return Bvh8Child(empty_bits); }

    /// A reference to inner node `index`; index <= max_node_index.
    [[nodiscard]] static constexpr Bvh8Child make_inner(std::uint32_t index) noexcept {
        return Bvh8Child(index);
    }

    /// A leaf of `count` blocks that starts at block `first`; first <= max_block_index and 1 <=
    /// count <= max_block_count.
    [[nodiscard]] static constexpr Bvh8Child make_leaf(std::uint32_t first,
                                                       std::uint32_t count) noexcept {
        return Bvh8Child(leaf_bit | (count - 1) << count_shift | first);
    }

    /// True if the slot is empty.
    [[nodiscard]] constexpr bool is_empty() const noexcept { return bits_ == empty_bits; }

    /// True if the slot holds a leaf.
    [[nodiscard]] constexpr bool is_leaf() const noexcept { return (bits_ & leaf_bit) != 0; }

    /// The index of the inner node. Inner nodes only.
    [[nodiscard]] constexpr std::uint32_t node() const noexcept { return bits_; }

    /// The index of the first block. Leaves only.
    [[nodiscard]] constexpr std::uint32_t first_block() const noexcept {
        return bits_ & max_block_index;
    }

    /// The number of blocks. Leaves only.
    [[nodiscard]] constexpr std::uint32_t block_count() const noexcept {
        return (bits_ >> count_shift & (max_block_count - 1)) + 1;
    }

    friend constexpr bool operator==(const Bvh8Child&, const Bvh8Child&) = default;

private:
    static constexpr std::uint32_t leaf_bit = 1U << 31;
    static constexpr unsigned count_shift = 27;
    static constexpr std::uint32_t empty_bits = leaf_bit - 1;  // no node has this index

    explicit constexpr Bvh8Child(std::uint32_t bits) noexcept : bits_(bits) {}

    std::uint32_t bits_;
};

/// An inner node: eight children with their boxes, stored bound by bound as the kernels load them.
/// Empty slots come last and have an empty box.
struct alignas(64) Bvh8Node {
    std::array<std::array<float, bvh8_width>, 6> bound;  ///< lower x, y, z, upper x, y, z
    std::array<Bvh8Child, bvh8_width> child;             ///< content of each slot
    std::array<std::uint32_t, 8> unused{};  ///< padding; 0, so that nodes compare as bytes

    /// The box of the child in a slot.
    [[nodiscard]] Aabb child_box(std::size_t slot) const noexcept {
        return {{bound[0][slot], bound[1][slot], bound[2][slot]},
                {bound[3][slot], bound[4][slot], bound[5][slot]}};
    }

    /// Sets the box and the content of a slot.
    void set(std::size_t slot, const Aabb& box, Bvh8Child what) noexcept {
        for (const Axis axis : all_axes) {
            bound[static_cast<std::size_t>(axis)][slot] = box.lower[axis];
            bound[3 + static_cast<std::size_t>(axis)][slot] = box.upper[axis];
        }
        child[slot] = what;
    }
};

static_assert(sizeof(Bvh8Node) == 256);

/// Up to eight triangles of a leaf, stored corner by corner and axis by axis as the kernels load
/// them. Lanes without a triangle come last. They have the id `no_triangle` and corners of NaN, so
/// that no ray hits them.
struct alignas(64) TriangleBlock {
    /// The id of a lane without a triangle.
    static constexpr std::uint32_t no_triangle = 0xffffffff;

    std::array<std::array<std::array<float, bvh8_width>, 3>, 3> corner;  ///< [corner][axis][lane]
    std::array<std::uint32_t, bvh8_width> id;  ///< id of the triangle in each lane

    /// The corners of the triangle in a lane.
    [[nodiscard]] Triangle triangle(std::size_t lane) const noexcept {
        const auto at = [&](std::size_t vertex) {
            return Vec3f{corner[vertex][0][lane], corner[vertex][1][lane], corner[vertex][2][lane]};
        };
        return {at(0), at(1), at(2)};
    }
};

static_assert(sizeof(TriangleBlock) == 320);

/// An immutable 8-wide bounding volume hierarchy (BVH) over triangles, with a copy of their
/// corners. Rays are traced against it. Node 0 is the root, children follow their parents, and the
/// blocks of a leaf are contiguous. Copies share their arrays.
class COPPICE_EXPORT Bvh8 {
public:
    /// The greatest depth of a node; the root has depth 0. The limit lets traversals use a stack of
    /// fixed size.
    static constexpr int max_depth = 64;

    /// A tree over no triangles: a root without children.
    Bvh8();

    /// A tree that refers to arrays which `storage` keeps alive, in the order described above.
    /// Throws Error(invalid_argument) if `nodes` is empty; validate() checks everything else.
    Bvh8(std::shared_ptr<const void> storage, std::span<const Bvh8Node> nodes,
         std::span<const TriangleBlock> blocks, const Aabb& bounds);

    /// All nodes, the root first.
    [[nodiscard]] std::span<const Bvh8Node> nodes() const noexcept { return nodes_; }

    /// The triangle blocks of all leaves.
    [[nodiscard]] std::span<const TriangleBlock> blocks() const noexcept { return blocks_; }

    /// The bounding box of all triangles.
    [[nodiscard]] const Aabb& bounds() const noexcept { return bounds_; }

    /// The size of nodes and blocks in bytes.
    [[nodiscard]] std::uint64_t byte_count() const noexcept {
        return nodes_.size_bytes() + blocks_.size_bytes();
    }

private:
    std::shared_ptr<const void> storage_;
    std::span<const Bvh8Node> nodes_;
    std::span<const TriangleBlock> blocks_;
    Aabb bounds_;
};

/// A node without children.
[[nodiscard]] COPPICE_EXPORT Bvh8Node make_empty_bvh8_node() noexcept;

}  // namespace coppice::inline v0
