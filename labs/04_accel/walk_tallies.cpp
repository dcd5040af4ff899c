#include "labs/04_accel/walk_tallies.h"

#include <numeric>

namespace raylab::lab04 {

void WalkTallies::clear() {
    tallies_.clear();
    rays_.assign(rays_.size(), 0);
    shadow_rays_ = 0;
}

void WalkTallies::write_to(Ledger& ledger) const {
    if (!ledger.structure && !ledger.shapes) return;
    const std::vector<WalkTally> tallies = tallies_.to_host();
    const auto sums = [](std::uint64_t rays, const WalkTally& tally) {
        return WalkSums{rays, tally.nodes, tally.packs};
    };
    for (int bounce = 0; bounce < bounces(); ++bounce)
        ledger.bounces[bounce].walks = sums(rays_[bounce], tallies[bounce]);
    if (ledger.structure) ledger.structure->shadow_rays = sums(shadow_rays_, tallies[bounces()]);
    if (!ledger.shapes) return;
    const auto rays = std::accumulate(rays_.begin(), rays_.end(), std::uint64_t{0});
    ledger.shapes->rays = sums(rays, tallies[bounces() + 1]);
    ledger.shapes->shadow_rays = sums(shadow_rays_, tallies[bounces() + 2]);
}

} // namespace raylab::lab04
