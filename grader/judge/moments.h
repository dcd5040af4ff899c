// Mean colour of a region and how well it is known: from replicates, or from a reference.
//
// The error of replicates is measured between them, never within one image: neighbouring pixels of
// a stratified or Sobol sampler, or of a shared pattern, are not independent.
#pragma once

#include "grader/judge/tiles.h"
#include "grader/judge/welch.h"

namespace raylab {

// R images of one scene that differ in nothing but the seed.
struct Replicates {
    int spp = 0; // of one replicate
    std::vector<Image> images;
    std::vector<TileSums> tiles;

    int count() const { return static_cast<int>(images.size()); }
    void add(Image image);
};

// Mean over replicates, and per pixel the standard error of that mean (common/image/mean.h).
Image mean_of(const Replicates& replicates);

// Mean R, G, B of a region, and the covariance of that mean.
struct Moments {
    DVec3 mean{0};
    glm::dmat3 covariance{0};
    double dof = 1;
};

// The moments over replicates (dof = R - 1). `kurtosis`, if given, receives the largest excess
// kurtosis of luminance and chroma: above 3 a few bright samples make the value, and t is no t.
Moments moments_of(const Replicates& replicates, const Region& region, double* kurtosis = nullptr);

// A reference image in tiles.
class ReferenceTiles {
  public:
    explicit ReferenceTiles(const Image& reference);

    // Pixels of a reference are independent; its channels are taken to be correlated as those of
    // `like`, since a file holds no covariance. dof = (sum v)^2 / sum v^2: one a pixel when all
    // have the same variance (a lower bound), few when few pixels make the error.
    Moments moments(const Region& region, const glm::dmat3& like) const;

    // How many pixels of the region do not know their error. moments() takes them as exact.
    double unknown(const Region& region) const { return unknown_.over(region).x; }

  private:
    TileSums mean_, variance_, squared_variance_, unknown_;
};

extern const DVec3 luminance_weights; // Rec. 709
extern const DVec3 colour_axes[3];    // luminance, R - G, B - G

// What is seen along one direction of colour space, e.g. luminance_weights.
Estimate project(const Moments& moments, const DVec3& direction);

// R - G and B - G: what luminance does not see.
Estimate2 chroma(const Moments& moments);

} // namespace raylab
