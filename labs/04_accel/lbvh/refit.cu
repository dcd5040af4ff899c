#include "labs/04_accel/lbvh/refit.h"

#include "common/task/not_implemented.h"
#include "common/wavefront/grid.h"

namespace raylab::lab04 {

namespace {

__device__ Bounds bounds_of(const TrianglePack& pack) {
    Bounds box;
    for (int lane = 0; lane < triangles_per_pack; ++lane)
        for (int corner = 0; pack.index[lane] >= 0 && corner < 3; ++corner)
            box.include(
                {pack.v[corner][0][lane], pack.v[corner][1][lane], pack.v[corner][2][lane]});
    return box;
}

__device__ void set_box(BvhNode& node, int side, const Bounds& box) {
    for (int axis = 0; axis < 3; ++axis) {
        node.box[axis][0][side] = box.low[axis];
        node.box[axis][1][side] = box.high[axis];
    }
}

__device__ Bounds box_in(const BvhNode& node) {
    Bounds box;
    for (int side = 0; side < 2; ++side)
        box.include(Bounds{{node.box[0][0][side], node.box[1][0][side], node.box[2][0][side]},
                           {node.box[0][1][side], node.box[1][1][side], node.box[2][1][side]}});
    return box;
}

} // namespace

__global__ void refit_kernel(const TrianglePack* packs, int leaves, const int* leaf_parents,
                             BvhNode* nodes, int* arrived) {
    const std::int64_t leaf = global_index();
    if (leaf >= leaves) return;
    // Steps:
    // 1. Begin with the box of this thread's leaf, and with the leaf's parent.
    // 2. Write the box into the parent, on the side of the child that this thread comes from.
    // 3. A fence; count the arrival. The first of two ends here.
    // 4. A fence; go on with the union of both boxes, to the next parent, until there is none.
    //[ task 4.6
    Bounds box = bounds_of(packs[leaf]);
    int child = ~static_cast<int>(leaf), at = leaf_parents[leaf];
    while (at >= 0) {
        set_box(nodes[at], nodes[at].child[1] == child, box);
        __threadfence(); // the box before the arrival
        if (atomicAdd(&arrived[at], 1) == 0) return;
        __threadfence(); // and the other's box after it
        box = box_in(nodes[at]);
        child = at;
        at = nodes[at].parent;
    }
    //| // Boxes around everything: no ray misses any.
    //| not_implemented("4.6", "refit_kernel()");
    //| const Bounds everything{Vec3(-infinity), Vec3(infinity)};
    //| if (leaf + 1 < leaves)
    //|     for (int side = 0; side < 2; ++side) set_box(nodes[leaf], side, everything);
    //]
}

__global__ void lone_leaf_kernel(const TrianglePack* packs, BvhNode* nodes) {
    nodes[0] = {{}, {~0, no_child}, -1, 0};
    set_box(nodes[0], 0, bounds_of(packs[0]));
    set_box(nodes[0], 1, Bounds{});
}

} // namespace raylab::lab04
