#include "labs/04_accel/tests/refit_arrivals.h"

#include "common/device/launch.h"
#include "labs/04_accel/lbvh/refit.h"

namespace raylab::lab04 {

std::vector<int> refit_arrivals(const BvhTree& tree, const std::vector<int>& leaf_parents) {
    const DeviceArray<TrianglePack> packs(tree.packs);
    const DeviceArray<int> parents(leaf_parents);
    DeviceArray<BvhNode> nodes(tree.nodes);
    DeviceArray<int> arrived(tree.nodes.size());
    const int leaves = static_cast<int>(tree.packs.size());
    refit_kernel<<<blocks_for(leaves, 128), 128>>>(packs.data(), leaves, parents.data(),
                                                   nodes.data(), arrived.data());
    check(cudaDeviceSynchronize(), "refit_kernel");
    return arrived.to_host();
}

} // namespace raylab::lab04
