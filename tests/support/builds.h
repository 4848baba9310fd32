#pragma once

#include "coppice/builders/build_tree.h"
#include "coppice/builders/method.h"
#include "coppice/store/tree_file.h"

#include <cstdint>
#include <utility>

namespace coppice::test {

/// A method's options without a crossover, so that small scenes go the way of large ones; a cell of
/// `cell_size` triangles, 0: as the method has it.
inline BuildOptions options_as_if_large(const Method& method, std::uint32_t cell_size = 0) {
    BuildOptions options = method.options();
    if (auto* const bvh8 = std::get_if<Bvh8Options>(&options)) {
        bvh8->sampled_from = 0;
        bvh8->cell_size = cell_size;
    }
    return options;
}

/// A tree of either kind, and how it was built.
struct AnyBuild {
    AnyTree tree;
    BuildReport report;
};

/// Builds a tree by options of either kind.
inline AnyBuild build_any(TriangleMeshView mesh, const BuildOptions& options,
                          const BuildControl& control = {}) {
    if (const auto* const kd = std::get_if<KdOptions>(&options)) {
        auto [tree, report] = build_kd_tree(mesh, *kd, control);
        return {std::move(tree), std::move(report)};
    }
    auto [tree, report] = build_bvh8(mesh, std::get<Bvh8Options>(options), control);
    return {std::move(tree), std::move(report)};
}

}  // namespace coppice::test
