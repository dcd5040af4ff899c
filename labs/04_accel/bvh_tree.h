// The tree on the host, as builders make it.
#pragma once

#include "labs/04_accel/bvh.h"
#include "labs/04_accel/triangle_block.h"

#include <vector>

namespace raylab::lab04 {

struct BvhTree {
    std::vector<BvhNode> nodes;        // the root first
    std::vector<TriangleBlock> blocks; // a leaf each
    int depth = 0;                     // nodes from the root to the deepest leaf

    std::size_t node_bytes() const { return nodes.size() * sizeof(BvhNode); }
    std::size_t block_bytes() const { return blocks.size() * sizeof(TriangleBlock); }
};

} // namespace raylab::lab04
