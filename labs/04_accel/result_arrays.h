// What outlives the paths: film, records, and what the ledger says of each bounce.
#pragma once

#include "common/device/device_array.h"
#include "labs/04_accel/accumulate.h"

#include <algorithm>

namespace raylab::lab04 {

class ResultArrays {
  public:
    // bounces: that are told apart; later ones count as the last.
    // records: whether each pixel's is kept.
    ResultArrays(int pixels, int bounces, bool records)
        : film_(pixels), records_(records ? pixels : 0),
          tallies_(static_cast<std::size_t>(shards) * bounces), shadow_rays_(shards),
          walks_(bounces + 3), launched_(bounces) {}

    // As kernels see them.
    Results view() {
        return {film_.data(), records_.data(), tallies_.data(), shadow_rays_.data(), bounces()};
    }

    // The host's part of a bounce's account: lanes, and how many rays walked.
    BounceCounts& of_bounce(int bounce) { return launched_[row_of(bounce)]; }
    std::uint64_t& shadow_rays_walked() { return shadow_rays_walked_; }

    // Where kernels add up what the walks of a bounce visited, and the walks of all shadow rays.
    WalkTally* walks_of_bounce(int bounce) { return walks_.data() + row_of(bounce); }
    WalkTally* walks_of_shadow_rays() { return walks_.data() + bounces(); }
    // The same through the tree over spheres and quads, all bounces together.
    WalkTally* walks_past_shapes() { return walks_.data() + bounces() + 1; }
    WalkTally* shadow_rays_past_shapes() { return walks_.data() + bounces() + 2; }

    // The film from first_pixel on, as many pixels as `pixels` has.
    void read_film(std::size_t first_pixel, std::vector<FilmPixel>& pixels) const {
        film_.to_host(first_pixel, pixels);
    }
    std::vector<PathRecord> records() const { return records_.to_host(); }

    // Sets the ledger's bounces, its shadow rays and, if it has structures, what was visited of
    // those.
    void write_to(Ledger& ledger) const;

  private:
    int bounces() const { return static_cast<int>(launched_.size()); }
    int row_of(int bounce) const { return std::min(bounce, bounces() - 1); }

    DeviceArray<FilmPixel> film_;
    DeviceArray<PathRecord> records_;
    DeviceArray<EndTally> tallies_;
    DeviceArray<unsigned long long> shadow_rays_;
    DeviceArray<WalkTally> walks_; // a row a bounce, and one each for the three that follow these
    std::vector<BounceCounts> launched_;
    std::uint64_t shadow_rays_walked_ = 0;
};

} // namespace raylab::lab04
