// The lecture's *wasted cycles*, counted.
//
// The 32 threads of a warp run in lockstep: while one of them still follows its path, the lanes of
// those that have finished are idle. The path kernel leaves a record of every path. Here, one
// thread for each warp reads the 32 records of that warp and adds them up, bounce by bounce.
#pragma once

#include "common/device/launch.h"
#include "common/film/ledger.h"
#include "common/task/not_implemented.h"

namespace raylab::lab02 {

// What a shard counts for one bounce. The host forms the sums over the bounces that follow.
struct BounceTally {
    unsigned long long ended[path_ends]; // paths that ended in this bounce
    unsigned long long warps_ended;      // warps whose longest path ended in this bounce
};

// Counters are *privatised*: threads of different blocks add to different copies (shards), so that
// they do not queue for one memory address; the host adds the copies up.
constexpr int shards = 64;

// records: one a pixel, as the path kernel left them. tallies: shards * max_bounces, added to.
// shadow_rays: one counter a shard.
__global__ void count_wasted_cycles(const PathRecord* records, int pixels, int max_bounces,
                                    BounceTally* tallies, unsigned long long* shadow_rays) {
    //[ task 2.6
    const int warp = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    const int first = warp * warp_lanes;
    if (first >= pixels) return;
    const int shard = static_cast<int>(blockIdx.x) % shards;
    BounceTally* tally = tallies + static_cast<long long>(shard) * max_bounces;

    int longest = 0;
    unsigned long long sent = 0;
    for (int lane = 0; lane < warp_lanes && first + lane < pixels; ++lane) {
        const PathRecord record = records[first + lane];
        const int last = min(static_cast<int>(record.length), max_bounces) - 1;
        atomicAdd(&tally[last].ended[static_cast<int>(record.end)], 1ull);
        longest = max(longest, last);
        sent += record.shadow_rays;
    }
    // A warp is busy from bounce 0 to the end of its longest path.
    atomicAdd(&tally[longest].warps_ended, 1ull);
    atomicAdd(&shadow_rays[shard], sent);
    //| not_implemented("2.6", "count_wasted_cycles()");
    //]
}

} // namespace raylab::lab02
