// A picture and how well it is known: one image with its own error, or several renders of one scene
// that differ in nothing but the seed.
//
// Pixels are taken as independent, but some renderers filter across pixels. Then neighbours share
// their noise, and the mean over a tile varies more than the errors of its pixels say. How much
// more is measured from the replicates, once for all tiles, since two or three replicates say
// little about a single tile. An error that all pixels have in common (one random offset for all)
// cannot be seen in this way: judge_replicates(), with 16 replicates, can see it.
#pragma once

#include "grader/judge/moments.h"

namespace raylab {

class NoisyImage {
  public:
    // At least one image. One image without an error is taken as exact where `exact` says so.
    explicit NoisyImage(const Replicates& replicates, bool exact = false);

    const Image& mean() const { return mean_; } // over the replicates

    // How many of the region's pixels do not know their error: channel() takes them as exact.
    double unknown(const Region& region) const { return exact_ ? 0 : tiles_.unknown(region); }

    // The region's mean in one channel (0 red, 1 green, 2 blue).
    Estimate channel(const Region& region, int c) const;

    // Variance of tile means over that of independent pixels, on average; 1 for a single image.
    double shared_noise() const { return shared_noise_; }

  private:
    Image mean_;
    ReferenceTiles tiles_;
    bool exact_;
    double shared_noise_ = 1;
    double shared_noise_dof_; // with which that was measured
};

} // namespace raylab
