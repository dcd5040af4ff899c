#include "common/wavefront/result_arrays.h"

namespace raylab {

void ResultArrays::clear() {
    film_.clear();
    tallies_.clear();
    shadow_rays_.clear();
    launched_.assign(launched_.size(), {});
}

// The shards are added up; a path that ended in bounce b was alive in bounces 0 to b, so rays are
// sums over the bounces that follow.
void ResultArrays::write_to(Ledger& ledger) const {
    const std::vector<EndTally> tallies = tallies_.to_host();
    ledger.bounces = launched_;
    std::uint64_t rays = 0;
    for (int bounce = bounces() - 1; bounce >= 0; --bounce) {
        BounceCounts& counts = ledger.bounces[bounce];
        for (int shard = 0; shard < shards; ++shard)
            for (int end = 0; end < path_ends; ++end) {
                const std::size_t row = static_cast<std::size_t>(shard) * bounces() + bounce;
                counts.ended[end] += tallies[row].ended[end];
                rays += tallies[row].ended[end];
            }
        counts.rays = rays;
    }
    for (const unsigned long long count : shadow_rays_.to_host()) ledger.shadow_rays += count;
}

} // namespace raylab
