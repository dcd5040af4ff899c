// The arrays that stay when paths end: the film, the records, and the counts of each bounce for the
// ledger.
#pragma once

#include "common/camera/camera.h"
#include "common/device/device_array.h"
#include "common/wavefront/results.h"

#include <algorithm>

namespace raylab {

class ResultArrays {
  public:
    // bounces: that are told apart; later ones count as the last.
    // records: whether each pixel's is kept.
    ResultArrays(int pixels, int bounces, bool records)
        : film_(pixels), records_(records ? pixels : 0),
          tallies_(static_cast<std::size_t>(shards) * bounces), shadow_rays_(shards),
          launched_(bounces) {}

    // As kernels see them.
    Results view() {
        return {film_.data(), records_.data(), tallies_.data(), shadow_rays_.data(), bounces()};
    }

    // The host's part of a bounce's account: lanes, blocks and batches.
    BounceCounts& of_bounce(int bounce) { return launched_[std::min(bounce, bounces() - 1)]; }

    // As Renderer::film().
    Film film(const Camera& camera, int first_row, int rows) const {
        Film strip(camera.width, std::min(rows, camera.height - first_row));
        film_.to_host(std::size_t{1} * first_row * strip.width, strip.pixels);
        return strip;
    }
    std::vector<PathRecord> records() const { return records_.to_host(); }

    // The film is empty and nothing has been counted; the next sample writes new records.
    void clear();

    // Sets the ledger's bounces and its shadow rays.
    void write_to(Ledger& ledger) const;

  private:
    int bounces() const { return static_cast<int>(launched_.size()); }

    DeviceArray<FilmPixel> film_;
    DeviceArray<PathRecord> records_;
    DeviceArray<EndTally> tallies_;
    DeviceArray<unsigned long long> shadow_rays_;
    std::vector<BounceCounts> launched_;
};

} // namespace raylab
