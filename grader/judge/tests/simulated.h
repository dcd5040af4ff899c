// Renders that are not rendered: a known true image plus noise of a known kind. Fast enough to
// grade thousands of times, which is how a false-alarm rate is measured.
#pragma once

#include "grader/judge/independent.h"

#include <cmath>
#include <cstdint>

namespace raylab::simulated {

// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
  public:
    // The seed is mixed: neighbouring seeds must not give one stream, shifted.
    explicit Random(std::uint64_t seed) : state_(seed * 0xd1342543de82ef95u) { state_ = bits(); }
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    // Three independent uniform numbers of mean 0 and variance 1.
    Vec3 noise() {
        const std::uint64_t b = bits();
        const auto one = [&](int shift) {
            return (float(b >> shift & 0x1fffff) / 0x1fffff - 0.5f) * 3.4641016f;
        };
        return {one(0), one(21), one(42)};
    }
    double uniform() { return double(bits() >> 11) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

enum class Noise {
    pixel,      // every pixel on its own
    stratified, // neighbours' errors cancel, as with a sampler stratified over the image
    shared,     // all pixels share half of their error, as when they share a random offset
    fireflies,  // one pixel in 500 is 30 times too bright, the others make up for it
};

constexpr float cv = 0.5f; // standard deviation over mean of one sample
constexpr int reference_spp = 16384;

// A smooth true image in three colours, values between 0.2 and 0.8.
inline Vec3 truth(int x, int y, int width, int height) {
    const float u = float(x) / float(width), v = float(y) / float(height);
    return {0.2f + 0.6f * u, 0.2f + 0.6f * v, 0.8f - 0.3f * (u + v)};
}

// Fireflies: in a render of `spp` samples this share of pixels is too bright by so many times.
constexpr float firefly_rate = 1.0f / 500, firefly_gain = 30;

// Variance of one sample, relative to the squared truth. R has more: see the 0.9 below.
inline Vec3 sample_variance(Noise noise, int spp) {
    const Vec3 coloured(1.3f * 1.3f, 0.97f, 0.97f);
    if (noise == Noise::fireflies)
        return cv * cv * coloured + Vec3(float(spp) * firefly_rate * firefly_gain * firefly_gain);
    return cv * cv * coloured;
}

// Mostly one factor for all three channels, as the noise of paths is.
inline Vec3 coloured(Vec3 n) { return 0.9f * Vec3(n.x) + 0.4f * n; }

// `scale(x, y)` multiplies the truth: the error to be found. 1 everywhere: a correct render.
template <class Scale>
Image render(int width, int height, std::uint64_t seed, int spp, Noise noise, Scale scale) {
    Image image;
    image.width = width;
    image.height = height;
    image.mean.resize(image.pixels());
    image.provenance.spp = spp;
    Random random(seed);
    const float sigma = cv / std::sqrt(float(spp)), half = std::sqrt(0.5f);
    const Vec3 common = random.noise();
    Vec3 last = random.noise();
    std::size_t i = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, ++i) {
            const Vec3 now = random.noise();
            Vec3 relative = sigma * (noise == Noise::stratified ? half * coloured(now - last)
                                     : noise == Noise::shared   ? half * coloured(now + common)
                                                                : coloured(now));
            if (noise == Noise::fireflies)
                relative += Vec3((random.uniform() < firefly_rate ? firefly_gain : 0) -
                                 firefly_rate * firefly_gain);
            last = now;
            image.mean[i] = truth(x, y, width, height) * (Vec3(1) + relative) * Vec3(scale(x, y));
        }
    return image;
}

inline Image render(int width, int height, std::uint64_t seed, int spp, Noise noise) {
    return render(width, height, seed, spp, noise, [](int, int) { return 1.0f; });
}

// A reference of many samples, whose variance is known. `spp`: that of the renders to be judged.
inline Image reference(int width, int height, std::uint64_t seed, Noise noise, int spp) {
    Image image = render(width, height, seed, 1, Noise::pixel);
    image.provenance.spp = reference_spp;
    image.error.resize(image.pixels());
    Random random(~seed);
    const Vec3 variance = sample_variance(noise, spp) / float(reference_spp);
    const Vec3 norm = glm::sqrt(variance / Vec3(1.69f, 0.97f, 0.97f));
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const Vec3 t = truth(int(i) % width, int(i) / width, width, height);
        image.mean[i] = t * (Vec3(1) + norm * coloured(random.noise()));
        image.error[i] = t * glm::sqrt(variance);
    }
    return image;
}

inline Replicates replicates(int width, int height, std::uint64_t seed, int spp, Noise noise,
                             int count = 16) {
    Replicates result{spp, {}, {}};
    for (int r = 0; r < count; ++r)
        result.add(render(width, height, seed * 1000 + std::uint64_t(r), spp, noise));
    return result;
}

} // namespace raylab::simulated
