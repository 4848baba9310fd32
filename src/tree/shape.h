#pragma once

#include "coppice/tree/bvh8.h"
#include "coppice/tree/kd_tree.h"

#include "tree/issue_list.h"

namespace coppice::inline v0 {

/// Reports what could lead a walk out of a tree's arrays or into a loop: children are in range,
/// after their parents, of one parent each and not too deep, every node but the root has a parent,
/// leaves hold what exists, and empty slots come last with the empty box. One pass over the nodes;
/// it ends at the first node that is too deep.
void check_shape(const KdTree& tree, IssueList& issues);
void check_shape(const Bvh8& tree, IssueList& issues);

}  // namespace coppice::inline v0
