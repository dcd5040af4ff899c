// The film: what each pixel has collected so far.
//
// Sums are double. In float, 2e7 additions of heavy-tailed samples lose 5 %, even as a running
// mean; in double they lose nothing that a float image shows. One thread owns one pixel, so no sum
// depends on an order.
#pragma once

#include "common/image/image.h"
#include "common/math/numbers.h"
#include "common/math/vec.h"

#include <vector>

namespace raylab {

struct FilmPixel {
    double sum[3];         // of radiance, per channel
    double sum_squares[3]; // of radiance squared
    unsigned samples;      // how many radiances the sums hold
    unsigned rejected; // samples that were NaN or infinite: counted, kept out, and graded as a bug
};

// Adds one sample's radiance to its pixel.
HD void add_sample(FilmPixel& pixel, Vec3 radiance) {
    if (!is_finite(radiance)) {
        ++pixel.rejected;
        return;
    }
    const double rgb[3] = {radiance.x, radiance.y, radiance.z};
    for (int c = 0; c < 3; ++c) {
        pixel.sum[c] += rgb[c];
        pixel.sum_squares[c] += rgb[c] * rgb[c];
    }
    ++pixel.samples;
}

struct Film {
    int width = 0, height = 0;
    std::vector<FilmPixel> pixels; // row by row, top row first

    Film() = default;
    Film(int film_width, int film_height)
        : width(film_width), height(film_height),
          pixels(static_cast<std::size_t>(film_width) * film_height, FilmPixel{}) {}
};

// Mean of every pixel and its standard error:
//     mean = S / n,   error^2 = (SS / n - mean^2) / (n - 1).
// The error takes the samples as independent, so for Sobol samples it is an upper estimate. With
// less than two samples it is infinite; a pixel without samples is black.
Image develop(const Film& film);

// The same for a strip of a film, into the pixels of `image` from first_pixel on.
void develop(const Film& strip, Image& image, std::size_t first_pixel);

// Whether two films hold the same bits, those of NaN and of -0 included.
bool same_bits(const Film& a, const Film& b);

} // namespace raylab
