#pragma once

#include "coppice/tree/kd_tree.h"
#include "coppice/tree/validate.h"
#include "coppice/tree/walk.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace coppice {

/// For gtest's messages.
inline void PrintTo(const ValidationIssue& finding,  // NOLINT(readability-identifier-naming)
                    std::ostream* stream) {
    *stream << name_of(finding.kind) << ": " << finding.message;
}

}  // namespace coppice

namespace coppice::test {

/// Success, or the first findings of validate().
[[nodiscard]] inline testing::AssertionResult is_sound(const KdTree& tree,
                                                       PrimitiveSetView primitives) {
    const std::vector<ValidationIssue> findings = validate(tree, primitives, 3);
    if (findings.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << testing::PrintToString(findings);
}

/// The same for an 8-wide tree.
[[nodiscard]] inline testing::AssertionResult is_sound(const Bvh8& tree, TriangleMeshView mesh) {
    const std::vector<ValidationIssue> findings = validate(tree, mesh, 3);
    if (findings.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << testing::PrintToString(findings);
}

/// True if two 8-wide trees are equal, byte for byte.
[[nodiscard]] inline bool is_same(const Bvh8& a, const Bvh8& b) {
    const auto is_same_bytes = [](auto x, auto y) {
        return x.size_bytes() == y.size_bytes() &&
               std::memcmp(x.data(), y.data(), x.size_bytes()) == 0;
    };
    return a.bounds() == b.bounds() && is_same_bytes(a.nodes(), b.nodes()) &&
           is_same_bytes(a.blocks(), b.blocks());
}

/// Success if nodes and references stand in the order that KdTree documents.
[[nodiscard]] inline testing::AssertionResult is_in_order(const KdTree& tree) {
    std::uint32_t next_pair = 1;
    std::uint32_t next_reference = 0;
    std::string fault;
    walk(tree, [&](const VisitedNode& at) {
        const KdNode& node = tree.nodes()[at.index];
        if (!node.is_leaf()) {
            if (node.lower_child() != next_pair) {
                fault = "child of node " + std::to_string(at.index);
            }
            next_pair += 2;
        } else if (node.reference_count() > 0) {
            if (node.first_reference() != next_reference) {
                fault = "references of leaf " + std::to_string(at.index);
            }
            next_reference += node.reference_count();
        }
    });
    if (next_pair != tree.nodes().size()) fault = "node count";
    if (next_reference != tree.references().size()) fault = "reference count";
    if (fault.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "out of order: " << fault;
}

/// The depth of the deepest node.
[[nodiscard]] inline int depth_of(const KdTree& tree) {
    int depth = 0;
    walk(tree, [&](const VisitedNode& at) { depth = std::max(depth, at.depth); });
    return depth;
}

/// The number of different ids in all leaves.
[[nodiscard]] inline std::size_t distinct_reference_count(const KdTree& tree) {
    return std::set(tree.references().begin(), tree.references().end()).size();
}

/// The references of the largest leaf.
[[nodiscard]] inline std::uint32_t largest_leaf(const KdTree& tree) {
    std::uint32_t largest = 0;
    for (const KdNode& node : tree.nodes()) {
        if (node.is_leaf()) largest = std::max(largest, node.reference_count());
    }
    return largest;
}

}  // namespace coppice::test
