// The wide tree on the host.
#pragma once

#include "labs/04_accel/bvh/tree.h"
#include "labs/04_accel/wide/wide_bvh.h"

namespace raylab::lab04 {

struct WideTree {
    std::vector<WideNode> nodes;
    std::vector<TrianglePack> packs;
    Vec3 extent = Vec3(0); // the largest |coordinate| on each axis
    int levels = 0;

    std::size_t node_bytes() const { return nodes.size() * sizeof(WideNode); }
    std::size_t pack_bytes() const { return packs.size() * sizeof(TrianglePack); }
};

// The binary tree with up to eight grandchildren drawn up into each node.
WideTree build_wide(const BvhTree& tree);

} // namespace raylab::lab04
