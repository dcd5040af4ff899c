// The structure over the triangles as kernels see it, and what walks through it leave behind.
#pragma once

#include "labs/04_accel/bvh/bvh.h"
#include "labs/04_accel/bvh/skip_tree.h"
#include "labs/04_accel/kd/tree.h"
#include "labs/04_accel/leaf/query.h"
#include "labs/04_accel/wide/wide_bvh.h"

namespace raylab::lab04 {

// At most one of the trees is there; the others are empty. The leaves of each tree are numbers of
// packs of triangles.
struct StructureView {
    Leaves leaves;
    KdView kd;
    BvhView bvh;
    SkipView skip; // the binary tree once more, in a line
    WideView wide;
};

// A ray whose walk did not end.
struct EndlessRay {
    int found = 0; // 1: there is one
    std::uint32_t pixel = 0;
    Ray ray = {};
};

struct WalkReport {
    WalkCounts* counts;  // a walk each, in the order of the launch's list
    EndlessRay* endless; // the first one
};

} // namespace raylab::lab04
