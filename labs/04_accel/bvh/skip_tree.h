// The binary tree in a line, depth first. Each node says where to go on if the ray misses it.
//
// A walk that always visits the first child first goes through the nodes in the order of the line.
// It only jumps over the nodes below a box that the ray misses. Smits, Efficiency Issues
// for Ray Tracing, Journal of Graphics Tools 3(2), 1998.
#pragma once

#include "common/geometry/bounds.h"
#include "common/scene/view.h"
#include "labs/04_accel/bvh/tree.h"

namespace raylab::lab04 {

struct SkipNode {
    Bounds box;
    int skip; // the node after all that is below this one
    int pack; // of a leaf; -1: the first child is the next node
};
static_assert(sizeof(SkipNode) == 32, "two a cache line");

struct SkipView {
    Array<SkipNode> nodes; // in the order of the walk
};

// The nodes of `tree`, leaves included, depth first.
std::vector<SkipNode> lay_skip_links(const BvhTree& tree);

} // namespace raylab::lab04
