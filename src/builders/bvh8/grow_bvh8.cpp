// Builds the 8-wide tree below and above the cells in one recursion. A node starts with one child
// and opens the child of largest area until it has eight: a top node into its two children, a range
// of PrimRefs by a binned split. No binary tree is made. Ranges of at most two blocks become
// leaves. While a node has free slots, leaves of more than one block are opened, too, and roomy
// ones always. Large children are tasks with a part of their own. The boundaries of parts depend on
// sizes alone, so that the tree does not depend on threads.
// Source: [Wald2007] sec. 3, [Wald2008] sec. 3 (opening by area).

#include "builders/bvh8/grow_bvh8.h"

#include "coppice/base/parallel.h"

#include "builders/bvh8/spatial_splitter.h"
#include "builders/work_share.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::inline v0::bvh8 {
namespace {

constexpr std::uint32_t block_size = bvh8_width;
constexpr std::uint32_t max_leaf_size = 2 * block_size;

// Smaller ranges do not justify a task and a part of their own.
constexpr std::uint32_t min_task_size = 2048;

// From this depth on, ranges are halved by count, so that 2^32 PrimRefs reach leaves within 11 more
// levels.
constexpr int max_sah_depth = Bvh8::max_depth - 12;

constexpr std::uint32_t not_top = 0xffffffff;

// A ray that starts in a leaf's box tests its triangles, even if nearer ones are elsewhere. So a
// leaf that fills more than this share of the scene, such as a wall of a room, is split further,
// unless the halves fill more than `most_filled` of its volume. Rays in a bathroom then take a
// third less time.
// Source: see [Fabianowski2009]; the measurements are in docs/decisions/0005.
constexpr double roomy_share = 0.01;
constexpr double most_filled = 1.5;

Aabb to_aabb(const Box8& box) {
    return {{box.lower(0), box.lower(1), box.lower(2)}, {box.upper(0), box.upper(1), box.upper(2)}};
}

double volume_of(const Box8& box) {
    double volume = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        volume *= double{box.upper(axis)} - double{box.lower(axis)};
    }
    return volume;
}

// A future child: a node of the top tree, or a range of PrimRefs.
struct Item {
    Range range;  // for a top node: its box and the number of PrimRefs below
    std::uint32_t top = not_top;
    double area = 0.0;
    bool is_roomy = false;

    [[nodiscard]] bool is_range() const noexcept { return top == not_top; }

    [[nodiscard]] bool can_open() const noexcept {
        return !is_range() || range.size() > (is_roomy ? 1 : block_size);
    }

    [[nodiscard]] bool is_leaf() const noexcept {
        return is_range() && range.size() <= (is_roomy ? 1 : max_leaf_size);
    }
};

class Grower {
public:
    Grower(const TopTree& top, std::span<const Range> cells, const Splitter& splitter,
           const SpatialSplitter& spatial, std::span<std::uint32_t> ids)
        : top_(top),
          splitter_(splitter),
          spatial_(spatial),
          ids_(ids),
          ranges_(top.nodes().size()) {
        for (std::size_t node = top.nodes().size(); node-- > 0;) {
            ranges_[node] = range_of(top.nodes()[node], cells);
        }
    }

    [[nodiscard]] GrownTree grow(WorkShare work) && {
        GrownTree grown;
        grown.bounds = to_aabb(ranges_[0].box);
        grow_node(grown.root, make_item(0), 0, work);
        return grown;
    }

private:
    struct Children {
        std::array<Item, bvh8_width> item;
        std::size_t count = 0;

        void add(const Item& added) {
            if (added.range.size() > 0) item[count++] = added;
        }

        // Sorts children by area per PrimRef, the greatest last. Any-hit queries begin there: such
        // a child is the most likely to be hit for the least work.
        void sort_for_any_hit() {
            const auto comes_before = [](const Item& a, const Item& b) {
                return a.area * b.range.size() < b.area * a.range.size();
            };
            const auto end = item.begin() + static_cast<std::ptrdiff_t>(count);
            for (auto next = item.begin(); next != end; ++next) {
                std::rotate(std::upper_bound(item.begin(), next, *next, comes_before), next,
                            next + 1);
            }
        }
    };

    // The range of a cell. For an inner node, the box of both children and the sum of their sizes.
    [[nodiscard]] Range range_of(const TopTree::Node& node, std::span<const Range> cells) const {
        if (node.is_cell) return cells[node.index];
        Range range = ranges_[node.index];
        const Range& upper = ranges_[node.index + 1];
        range.end = range.begin + range.size() + upper.size();
        range.box.grow(upper.box);
        return range;
    }

    [[nodiscard]] Item make_item(std::uint32_t node) const {
        const bool is_cell = top_.nodes()[node].is_cell;
        return make_item(ranges_[node], is_cell ? not_top : node);
    }

    [[nodiscard]] Item make_item(const Range& range, std::uint32_t top = not_top) const {
        const bool is_roomy = volume_of(range.box) > roomy_share * volume_of(ranges_[0].box);
        return {range, top, to_aabb(range.box).surface_area(), is_roomy};
    }

    void open(Children& children, std::size_t at, bool by_sah) const {
        Item opened = children.item[at];
        std::swap(children.item[at], children.item[--children.count]);
        if (!opened.is_range()) {
            const std::uint32_t lower = top_.nodes()[opened.top].index;
            children.add(make_item(lower));
            children.add(make_item(lower + 1));
            return;
        }
        const Halves halves = by_sah ? split(opened.range) : splitter_.halve(opened.range);
        const double filled = volume_of(halves.lower.box) + volume_of(halves.upper.box);
        if (opened.range.size() <= block_size &&
            filled > most_filled * volume_of(opened.range.box)) {
            opened.is_roomy = false;  // its PrimRefs have not been moved
            children.add(opened);
            return;
        }
        children.add(make_item(halves.lower));
        children.add(make_item(halves.upper));
    }

    // Splits by the centroids of PrimRefs, or at a plane that cuts them if that is cheaper.
    [[nodiscard]] Halves split(const Range& range) const {
        BinMapping mapping{};
        const ObjectSplit split = splitter_.find(range, mapping);
        if (const auto halves = spatial_.improve(range, split)) return *halves;
        return splitter_.divide(range, split, mapping);
    }

    [[nodiscard]] Children open_all(const Item& item, int depth) const {
        const bool by_sah = depth < max_sah_depth;
        const auto extent = [&](const Item& child) {
            if (!child.can_open()) return -1.0;
            return by_sah ? child.area : static_cast<double>(child.range.size());
        };
        Children children;
        children.add(item);
        while (children.count > 0 && children.count < bvh8_width) {
            std::size_t largest = 0;
            for (std::size_t at = 1; at < children.count; ++at) {
                if (extent(children.item[at]) > extent(children.item[largest])) largest = at;
            }
            if (!children.item[largest].can_open()) break;
            open(children, largest, by_sah);
        }
        children.sort_for_any_hit();
        return children;
    }

    // Writes a leaf's ids at the indices of its PrimRefs. Only one task owns this range.
    Bvh8Child grow_leaf(Part& part, const Range& range) {
        const auto prim_refs = splitter_.prim_refs(range);
        std::transform(prim_refs.begin(), prim_refs.end(), ids_.begin() + range.begin,
                       [](const PrimRef& prim_ref) { return prim_ref.id; });
        const std::uint32_t first = part.block_count;
        const std::uint32_t count = (range.size() + block_size - 1) / block_size;
        part.leaves.push_back({range.begin, range.size()});
        part.block_count += count;
        return Bvh8Child::make_leaf(first, count);
    }

    std::uint32_t grow_node(Part& part, const Item& item, int depth, WorkShare work = {}) {
        const auto index = static_cast<std::uint32_t>(part.nodes.size());
        part.nodes.push_back(make_empty_bvh8_node());
        const Children children = open_all(item, depth);
        std::vector<std::pair<std::size_t, const Item*>> tasks;
        for (std::size_t slot = 0; slot < children.count; ++slot) {
            const Item& child = children.item[slot];
            const Aabb box = to_aabb(child.range.box);
            part.nodes[index].set(slot, box, Bvh8Child::make_empty());
            if (child.is_leaf()) {
                part.nodes[index].child[slot] = grow_leaf(part, child.range);
            } else if (child.range.size() >= min_task_size) {
                tasks.emplace_back(slot, &child);
            } else {
                const std::uint32_t node = grow_node(part, child, depth + 1);
                part.nodes[index].child[slot] = Bvh8Child::make_inner(node);
            }
        }
        double of_tasks = 0.0;
        for (const auto& [slot, child] : tasks) {
            of_tasks += work_of(child->range.size());
        }
        const double all = std::max(work_of(item.range.size()), of_tasks);
        work.part(1.0 - of_tasks / all).done();
        if (!tasks.empty()) grow_parts(part, index, tasks, depth + 1, work.part(of_tasks / all));
        return index;
    }

    // The work below a range, in PrimRefs visited: one pass for each level of binary splits above
    // the leaves.
    static double work_of(std::uint32_t size) {
        return size * std::log2(std::max(size, block_size) / (0.5 * block_size));
    }

    // Grows large children in parallel, the largest first.
    void grow_parts(Part& part, std::uint32_t node,
                    std::vector<std::pair<std::size_t, const Item*>>& tasks, int depth,
                    WorkShare work) {
        std::stable_sort(tasks.begin(), tasks.end(), [](const auto& a, const auto& b) {
            return a.second->range.size() > b.second->range.size();
        });
        const std::size_t first = part.links.size();
        double all = 0.0;
        for (const auto& [slot, item] : tasks) {
            all += work_of(item->range.size());
            part.links.push_back(
                {node, static_cast<std::uint32_t>(slot), std::make_unique<Part>()});
        }
        parallel_for_chunks(tasks.size(), 1, [&](std::size_t task, std::size_t /*end*/) {
            throw_if_cancelled();
            const Item& item = *tasks[task].second;
            grow_node(*part.links[first + task].part, item, depth,
                      work.part(work_of(item.range.size()) / all));
        });
    }

    const TopTree& top_;
    const Splitter& splitter_;
    const SpatialSplitter& spatial_;
    std::span<std::uint32_t> ids_;
    std::vector<Range> ranges_;  // ranges of the top tree's nodes
};

}  // namespace

std::uint64_t byte_count(const Part& part) noexcept {
    std::uint64_t bytes = part.nodes.capacity() * sizeof(Bvh8Node) +
                          part.leaves.capacity() * sizeof(Part::Leaf) +
                          part.links.capacity() * sizeof(Part::Link);
    for (const Part::Link& link : part.links) {
        bytes += byte_count(*link.part);
    }
    return bytes;
}

GrownTree grow_bvh8(const Cells& cells, TriangleMeshView mesh, const Kernels& kernels,
                    Progress* progress) {
    Box8 bounds = Box8::make_empty();
    for (const Range& range : cells.ranges) {
        bounds.grow(range.box);
    }
    const SplitCosts costs{static_cast<float>(block_size), true, extent_factor_of(bounds)};
    const Splitter splitter(cells.buffers.first(), cells.buffers.second(), costs, kernels);
    const SpatialSplitter spatial(cells.buffers.first(), cells.buffers.second(), mesh, bounds,
                                  kernels);
    return Grower(cells.top, cells.ranges, splitter, spatial, cells.buffers.ids())
        .grow(WorkShare(progress));
}

}  // namespace coppice::inline v0::bvh8
