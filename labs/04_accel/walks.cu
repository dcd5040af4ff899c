// Kernels for each row of the table of walks.
#include "labs/04_accel/walks.h"

#include "labs/04_accel/walk_kernels.h"
#include "labs/04_accel/walk_table.h"

namespace raylab::lab04 {

const std::vector<KnownWalk>& known_walks() {
    static const std::vector<KnownWalk> walks = [] {
        std::vector<KnownWalk> rows;
        for_each_walk([&]<class Walk>(const char* structure, Walk) {
            rows.push_back({structure,
                            Walk::name,
                            Walk::title,
                            Walk::when_endless,
                            prepare_of<Walk>(),
                            {walk_closest_kernel<Walk>, walk_any_kernel<Walk>}});
        });
        return rows;
    }();
    return walks;
}

} // namespace raylab::lab04
