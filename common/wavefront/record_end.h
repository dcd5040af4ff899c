// What is noted of a path that has ended: its record, for tests that compare paths; its length and
// the cause of its end, for the ledger. For files of kernels.
#pragma once

#include "common/simt/cuda.h"
#include "common/wavefront/path_pool.h"
#include "common/wavefront/results.h"

namespace raylab {

__device__ inline void record_end(const PathPoolView& pool, int slot, const Results& results) {
    const PathRecord record = pool.record[slot];
    if (results.records != nullptr) results.records[pool.pixel[slot]] = record;
    const int length = record.length < results.bounces ? record.length : results.bounces;
    if (length == 0) return; // never traced
    const int shard = static_cast<int>(blockIdx.x % shards);
    EndTally* tally = results.tallies + static_cast<std::int64_t>(shard) * results.bounces;
    atomicAdd(&tally[length - 1].ended[static_cast<int>(record.end)], 1ull);
    atomicAdd(&results.shadow_rays[shard], static_cast<unsigned long long>(record.shadow_rays));
}

} // namespace raylab
