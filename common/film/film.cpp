#include "common/film/film.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace raylab {

void develop(const Film& strip, Image& image, std::size_t first_pixel) {
    for (std::size_t i = 0; i < strip.pixels.size(); ++i) {
        const FilmPixel& pixel = strip.pixels[i];
        Vec3 &mean = image.mean[first_pixel + i], &error = image.error[first_pixel + i];
        mean = Vec3(0);
        error = Vec3(infinity);
        const double n = pixel.samples;
        if (n == 0) continue;
        for (int c = 0; c < 3; ++c) {
            const double m = pixel.sum[c] / n;
            mean[c] = static_cast<float>(m);
            if (n < 2) continue;
            const double variance = std::max(0.0, pixel.sum_squares[c] / n - m * m) / (n - 1);
            error[c] = static_cast<float>(std::sqrt(variance));
        }
    }
}

Image develop(const Film& film) {
    Image image;
    image.width = film.width;
    image.height = film.height;
    image.mean.resize(film.pixels.size());
    image.error.resize(film.pixels.size());
    develop(film, image, 0);
    return image;
}

bool same_bits(const Film& a, const Film& b) {
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(FilmPixel)) == 0;
}

} // namespace raylab
