#include "labs/04_accel/tests/planted_walk.h"

#include "labs/04_accel/walk_kernels.h"

namespace raylab::lab04 {

namespace {

struct EndlessTowardsX {
    template <class Query> HD static void walk(const StructureView&, Query& query) {
        while (query.ray().d.x > 0)
            if (!query.step()) return;
    }
};

} // namespace

WalkKernels planted_walk() {
    return {walk_closest_kernel<EndlessTowardsX>, walk_any_kernel<EndlessTowardsX>};
}

} // namespace raylab::lab04
