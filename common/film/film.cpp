#include "common/film/film.h"

#include <algorithm>
#include <cmath>

namespace raylab {

Image develop(const Film& film) {
    Image image;
    image.width = film.width;
    image.height = film.height;
    image.mean.resize(film.pixels.size(), Vec3(0));
    image.error.resize(film.pixels.size(), Vec3(infinity));
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const FilmPixel& pixel = film.pixels[i];
        const double n = pixel.samples;
        if (n == 0) continue;
        for (int c = 0; c < 3; ++c) {
            const double mean = pixel.sum[c] / n;
            (&image.mean[i].x)[c] = static_cast<float>(mean);
            if (n < 2) continue;
            const double variance = std::max(0.0, pixel.sum_squares[c] / n - mean * mean) / (n - 1);
            (&image.error[i].x)[c] = static_cast<float>(std::sqrt(variance));
        }
    }
    return image;
}

} // namespace raylab
