// The structure over the triangles in host memory: one of the trees, as its builder leaves it.
#pragma once

#include "common/render/renderer.h"
#include "labs/04_accel/bvh/skip_tree.h"
#include "labs/04_accel/kd/tree.h"
#include "labs/04_accel/structure.h"
#include "labs/04_accel/wide/tree.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raylab::lab04 {

// All but one are empty; without a structure all are, and the packs hold every triangle.
struct Trees {
    KdTree kd;
    BvhTree bvh;
    std::vector<SkipNode> skip; // the binary tree in a line, for the walk that reads it so
    WideTree wide;
    std::vector<TrianglePack> all_packs; // without a structure
    double seconds = 0;                  // of building, copies to a device and back left out

    const std::vector<TrianglePack>& packs() const;
    int nodes() const;
    int depth() const;         // nodes from the root to the deepest leaf
    std::size_t bytes() const; // of nodes and packs

    // For walks on the host. triangles: those it was built over.
    StructureView view(std::span<const Triangle> triangles) const;
};

// What a walk needs besides the tree.
using Prepare = void (*)(Trees& trees);

struct KnownStructure {
    const char* name;  // on the command line and in the ledger
    const char* title; // the same in words
    // Returns the seconds of building, if these differ from the time that has passed meanwhile.
    std::optional<double> (*build)(Trees& trees, const std::vector<Triangle>& triangles,
                                   const MachineSettings& machine);
};

// accel: a name in the table of walks.
const KnownStructure& known_structure(const std::string& accel);

// Builds it on the machine's threads, or, along the Morton curve, with kernels on the machine. Then
// calls prepare, unless it is null.
Trees build_trees(const KnownStructure& structure, Prepare prepare,
                  const std::vector<Triangle>& triangles, const MachineSettings& machine);

} // namespace raylab::lab04
