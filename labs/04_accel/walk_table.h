// The table of walks: a row for each structure and walk that go together. A new walk is a file and
// a row.
//
// The file defines a type, as bvh/walk_stack.h does at its end, with
//     name          of the walk, on the command line and in the ledger
//     title         the same in words
//     when_endless  the mistake that makes such a walk endless, for the message of endless_walk.h
//     walk(structure, query)
//     prepare(trees)  if the walk needs more than the bare tree: called once the tree is built
#pragma once

#include "labs/04_accel/bvh/walk_parent.h"
#include "labs/04_accel/bvh/walk_skip.h"
#include "labs/04_accel/bvh/walk_stack.h"
#include "labs/04_accel/bvh/walk_trail.h"
#include "labs/04_accel/kd/walk_restart.h"
#include "labs/04_accel/kd/walk_ropes.h"
#include "labs/04_accel/kd/walk_stack.h"
#include "labs/04_accel/leaf/visit_all.h"
#include "labs/04_accel/trees.h"
#include "labs/04_accel/wide/walk_stack.h"
#include "labs/04_accel/wide/walk_trail.h"

namespace raylab::lab04 {

// Calls use(structure, walk) for each row. The structures come from the fastest to the slowest, and
// so do the walks of each.
template <class Use> void for_each_walk(const Use& use) {
    use("wide", WideTrail());
    use("wide", WideStack());
    use("sah", BvhTrail());
    use("sah", BvhSkip());
    use("sah", BvhStack());
    use("sah", BvhParent());
    use("lbvh", BvhTrail());
    use("lbvh", BvhSkip());
    use("lbvh", BvhStack());
    use("lbvh", BvhParent());
    use("kd", KdStack());
    use("kd", KdRopes());
    use("kd", KdRestart());
    use("none", AllPacks());
}

// The walk's prepare(); null if it has none.
template <class Walk> constexpr Prepare prepare_of() {
    if constexpr (requires(Trees & trees) { Walk::prepare(trees); })
        return Walk::prepare;
    else
        return nullptr;
}

} // namespace raylab::lab04
