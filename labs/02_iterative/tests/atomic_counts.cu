// The kernel stands here once more, in a namespace whose atomicAdd() and atomicCAS() keep a second
// copy of the counts. Whatever else changes a count does not change its copy.
#include "labs/02_iterative/tests/atomic_counts.h"

#include "common/device/device_array.h"
#include "common/device/launch.h"
#include "common/film/ledger.h"
#include "common/task/not_implemented.h"

#include <cstdint>

namespace raylab::lab02 {

namespace seen {

using Count = unsigned long long;

struct Counts {
    Count *first, *copy; // `size` each
    long long size;
};
__device__ Counts counts;

template <class T> __device__ void add_to_copy(T* address, T n) {
    if constexpr (sizeof(T) == sizeof(Count)) {
        const long long at = reinterpret_cast<Count*>(address) - counts.first;
        if (at >= 0 && at < counts.size) ::atomicAdd(counts.copy + at, static_cast<Count>(n));
    }
}

template <class T, class N> __device__ T atomicAdd(T* address, N n) {
    add_to_copy(address, static_cast<T>(n));
    return ::atomicAdd(address, static_cast<T>(n));
}

template <class T, class N> __device__ T atomicCAS(T* address, N expected, N wanted) {
    const T found = ::atomicCAS(address, static_cast<T>(expected), static_cast<T>(wanted));
    if (found == static_cast<T>(expected)) add_to_copy(address, static_cast<T>(wanted - expected));
    return found;
}

#include "labs/02_iterative/wasted_cycles.h"

} // namespace seen

int changed_without_atomics(int paths) {
    namespace here = seen::raylab::lab02;
    constexpr int max_bounces = 2, block = 128;
    constexpr std::size_t tallies =
        std::size_t{here::shards} * max_bounces * sizeof(here::BounceTally) / sizeof(seen::Count);
    constexpr std::size_t size = tallies + here::shards;

    PathRecord one;
    one.end = PathEnd::escaped;
    one.length = one.shadow_rays = 1;
    const DeviceArray<PathRecord> records(std::vector<PathRecord>(paths, one));
    DeviceArray<seen::Count> both(2 * size);
    const seen::Counts counts = {both.data(), both.data() + size, size};
    check(cudaMemcpyToSymbol(seen::counts, &counts, sizeof counts), "cudaMemcpyToSymbol");
    here::count_wasted_cycles<<<blocks_for(warps_for(paths), block), block>>>(
        records.data(), paths, max_bounces, reinterpret_cast<here::BounceTally*>(counts.first),
        counts.first + tallies);
    check(cudaGetLastError(), "count_wasted_cycles launch");
    check(cudaDeviceSynchronize(), "count_wasted_cycles");

    const std::vector<seen::Count> host = both.to_host();
    int changed = 0;
    for (std::size_t i = 0; i < size; ++i) changed += host[i] != host[size + i];
    return changed;
}

} // namespace raylab::lab02
