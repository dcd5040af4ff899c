// Means of values or images that were drawn several times, each with its own seed. Their error is
// measured from the differences between the draws. This is right for any sampler, also if the
// samples of one draw are not independent.
#pragma once

#include "common/image/image.h"

#include <stdexcept>

namespace raylab {

// The mean of R values that come one by one, and the standard error of that mean:
//     error^2 = S_R / (R (R - 1)),   S_n = sum (x_r - T_n / n)^2,   T_n = x_1 + ... + x_n.
// S is updated so that no digits cancel:
//     S_n = S_(n-1) + (n x_n - T_n)^2 / (n (n - 1)).
// Youngs and Cramer, Some Results Relevant to Choice of Sum and Sum-of-Product Algorithms,
// Technometrics 13(3), 1971.
class Mean {
  public:
    void add(const DVec3& x) {
        const double n = ++count_;
        sum_ += x;
        const DVec3 d = n * x - sum_;
        if (count_ > 1) squares_ += d * d / (n * (n - 1));
    }
    DVec3 value() const { return sum_ / double(count_); }
    DVec3 error() const { // of two values or more
        const double n = count_;
        return glm::sqrt(squares_ / (n * (n - 1)));
    }

  private:
    DVec3 sum_{0}, squares_{0};
    int count_ = 0;
};

// The same for every pixel of images that differ in nothing but the seed.
class ImageMean {
  public:
    // Throws std::invalid_argument if the image has another size than those before.
    void add(const Image& image) {
        if (count_ == 0) {
            width_ = image.width, height_ = image.height;
            provenance_ = image.provenance;
            pixels_.assign(image.pixels(), {});
        }
        if (image.width != width_ || image.height != height_)
            throw std::invalid_argument("ImageMean: all images must have the same size");
        for (std::size_t i = 0; i < pixels_.size(); ++i) pixels_[i].add(DVec3(image.mean[i]));
        ++count_;
    }

    int count() const { return count_; }

    // With the provenance of the first image, whose samples count as often as there are images.
    // Throws std::invalid_argument if there are less than two.
    Image mean() const {
        if (count_ < 2) throw std::invalid_argument("ImageMean: at least two images are needed");
        Image image;
        image.width = width_;
        image.height = height_;
        image.provenance = provenance_;
        image.provenance.spp *= count_;
        image.mean.resize(pixels_.size());
        image.error.resize(pixels_.size());
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            image.mean[i] = Vec3(pixels_[i].value());
            image.error[i] = Vec3(pixels_[i].error());
        }
        return image;
    }

  private:
    int width_ = 0, height_ = 0, count_ = 0;
    Provenance provenance_;
    std::vector<Mean> pixels_;
};

} // namespace raylab
