// The table of walks. A new one is a type that calls it, and a row.
#include "labs/04_accel/walks.h"

#include "labs/04_accel/bvh/walk_parent.h"
#include "labs/04_accel/bvh/walk_skip.h"
#include "labs/04_accel/bvh/walk_stack.h"
#include "labs/04_accel/bvh/walk_trail.h"
#include "labs/04_accel/kd/walk_restart.h"
#include "labs/04_accel/kd/walk_ropes.h"
#include "labs/04_accel/kd/walk_stack.h"
#include "labs/04_accel/leaf/visit_all.h"
#include "labs/04_accel/walk_kernels.h"
#include "labs/04_accel/wide/walk_stack.h"
#include "labs/04_accel/wide/walk_trail.h"

namespace raylab::lab04 {

namespace {

// Brute force: every triangle of the scene.
struct AllPacks {
    template <class Query> HD static void walk(const StructureView&, Query& query) {
        visit_all_packs(query);
    }
};

struct KdStack {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_kd_stack(structure.kd, query);
    }
};
struct KdRopes {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_kd_ropes(structure.kd, query);
    }
};
struct KdRestart {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_kd_restart(structure.kd, query);
    }
};
struct BvhStack {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_stack(structure.bvh, query);
    }
};
struct BvhTrail {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_trail(structure.bvh, query);
    }
};
struct BvhSkip {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_skip(structure.skip, query);
    }
};
struct BvhParent {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_parent(structure.bvh, query);
    }
};
struct WideStack {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_wide_stack(structure.wide, query);
    }
};
struct WideTrail {
    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_wide_trail(structure.wide, query);
    }
};

template <class Walk>
constexpr WalkKernels kernels{walk_closest_kernel<Walk>, walk_any_kernel<Walk>};

} // namespace

const std::vector<KnownWalk>& known_walks() {
    static const std::vector<KnownWalk> walks = {
        {AccelKind::wide, WalkKind::trail, kernels<WideTrail>},
        {AccelKind::wide, WalkKind::stack, kernels<WideStack>},
        {AccelKind::sah, WalkKind::trail, kernels<BvhTrail>},
        {AccelKind::sah, WalkKind::skip, kernels<BvhSkip>},
        {AccelKind::sah, WalkKind::stack, kernels<BvhStack>},
        {AccelKind::sah, WalkKind::parent, kernels<BvhParent>},
        {AccelKind::lbvh, WalkKind::trail, kernels<BvhTrail>},
        {AccelKind::lbvh, WalkKind::skip, kernels<BvhSkip>},
        {AccelKind::lbvh, WalkKind::stack, kernels<BvhStack>},
        {AccelKind::lbvh, WalkKind::parent, kernels<BvhParent>},
        {AccelKind::kd, WalkKind::stack, kernels<KdStack>},
        {AccelKind::kd, WalkKind::ropes, kernels<KdRopes>},
        {AccelKind::kd, WalkKind::restart, kernels<KdRestart>},
        {AccelKind::none, WalkKind::automatic, kernels<AllPacks>},
    };
    return walks;
}

} // namespace raylab::lab04
