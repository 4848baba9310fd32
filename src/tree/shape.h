#pragma once

#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

#include "tree/issue_list.h"

namespace coppice::inline v0 {

/// Reports every fault that could lead a traversal out of a tree's arrays or into a loop. Children
/// must be in range, after their parents, with one parent each, and not too deep. Every node but
/// the root must have a parent. Leaves must refer to existing items. Empty slots must come last
/// with an empty box. One pass over the nodes; it ends at the first node that is too deep.
void check_shape(const KdTree& tree, IssueList& issues);
void check_shape(const Bvh8& tree, IssueList& issues);

}  // namespace coppice::inline v0
