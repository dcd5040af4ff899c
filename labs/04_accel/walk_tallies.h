// What walks visited, added up for the ledger.
#pragma once

#include "common/device/device_array.h"
#include "common/film/ledger.h"

#include <algorithm>

namespace raylab::lab04 {

// packs: of triangles; in the tree over spheres and quads, groups of these.
struct WalkTally {
    unsigned long long nodes, packs;
};

class WalkTallies {
  public:
    // bounces: that are told apart; later ones count as the last.
    explicit WalkTallies(int bounces) : tallies_(bounces + 3), rays_(bounces) {}

    // How many rays walked.
    std::uint64_t& rays_of_bounce(int bounce) { return rays_[row_of(bounce)]; }
    std::uint64_t& shadow_rays() { return shadow_rays_; }

    // Where kernels add up what the walks of a bounce visited, and the walks of all shadow rays.
    WalkTally* of_bounce(int bounce) { return tallies_.data() + row_of(bounce); }
    WalkTally* of_shadow_rays() { return tallies_.data() + bounces(); }
    // The same through the tree over spheres and quads, all bounces together.
    WalkTally* past_shapes() { return tallies_.data() + bounces() + 1; }
    WalkTally* shadow_rays_past_shapes() { return tallies_.data() + bounces() + 2; }

    // Nothing has walked.
    void clear();

    // Sets what was visited of the structures that the ledger has.
    void write_to(Ledger& ledger) const;

  private:
    int bounces() const { return static_cast<int>(rays_.size()); }
    int row_of(int bounce) const { return std::min(bounce, bounces() - 1); }

    DeviceArray<WalkTally> tallies_; // a row a bounce, and one each for the three that follow these
    std::vector<std::uint64_t> rays_;
    std::uint64_t shadow_rays_ = 0;
};

} // namespace raylab::lab04
