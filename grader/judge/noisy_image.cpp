// The spread of replicates, pixel by pixel, and how much of it neighbours share.
#include "grader/judge/noisy_image.h"

#include <algorithm>
#include <limits>

namespace raylab {

NoisyImage::NoisyImage(const Replicates& replicates, bool exact)
    : mean_(replicates.count() == 1 ? replicates.images[0] : mean_of(replicates)), tiles_(mean_),
      exact_(exact && mean_.error.empty()),
      shared_noise_dof_(std::numeric_limits<double>::infinity()) {
    if (replicates.count() == 1) return;
    const TileSums variance(mean_.width, mean_.height,
                            [&](std::size_t i) { return mean_.variance(i); });
    double sum = 0, noisy_tiles = 0;
    for (const Region& region : regions_of(mean_.width, mean_.height, tile_size)) {
        const glm::dmat3 together = moments_of(replicates, region).covariance;
        const DVec3 alone = variance.over(region);
        const double pixels = region.pixels(), independent = alone.x + alone.y + alone.z;
        if (independent <= 0) continue;
        sum += (together[0][0] + together[1][1] + together[2][2]) * (pixels * pixels / independent);
        ++noisy_tiles;
    }
    if (noisy_tiles == 0) return;
    shared_noise_ = sum / noisy_tiles;
    shared_noise_dof_ = noisy_tiles * (replicates.count() - 1);
}

Estimate NoisyImage::channel(const Region& region, int c) const {
    DVec3 axis(0);
    axis[c] = 1;
    Estimate estimate = project(tiles_.moments(region, glm::dmat3(1)), axis);
    // Never less noise than independent pixels have: samplers that spread errors over the image
    // gain little here, and are not punished.
    estimate.variance *= std::max(1.0, shared_noise_);
    // The relative variances of two factors add up, and each is 2 / dof.
    estimate.dof = 1 / (1 / estimate.dof + 1 / shared_noise_dof_);
    return estimate;
}

} // namespace raylab
