// Where the judge looks: tiles of 16 x 16 pixels, squares of tiles, and the whole image. A mean
// over a tile has far less noise than a pixel, and still shows one wrong object where a whole-image
// error does not. Sums over larger regions are sums of tiles, so pixels are read once.
#pragma once

#include "common/image/image.h"
#include "grader/judge/verdict.h"

namespace raylab {

constexpr int tile_size = 16;

// All size x size regions of an image, cut at its right and lower edge, row by row. `size` is
// tile_size times a power of two.
std::vector<Region> regions_of(int width, int height, int size);

// The region of twice the size that holds `region` (of width `size` before cutting).
Region parent_of(const Region& region, int size, int width, int height);

// Sums over 16 x 16 tiles, in double, of a per-pixel quantity.
class TileSums {
  public:
    // value(i): the DVec3 of pixel i.
    template <class Value> TileSums(int width, int height, Value value);
    explicit TileSums(const std::vector<Vec3>& pixels, int width, int height)
        : TileSums(width, height, [&](std::size_t i) { return DVec3(pixels[i]); }) {}

    // Sum over a region whose corners are tile corners or the image's edge.
    DVec3 over(const Region& region) const;

  private:
    int columns_;
    std::vector<DVec3> sums_;
};

template <class Value>
TileSums::TileSums(int width, int height, Value value)
    : columns_((width + tile_size - 1) / tile_size),
      sums_(std::size_t(columns_) * ((std::size_t(height) + tile_size - 1) / tile_size), DVec3(0)) {
    std::size_t i = 0;
    for (int y = 0; y < height; ++y) {
        DVec3* row = &sums_[std::size_t(y / tile_size) * std::size_t(columns_)];
        for (int x = 0; x < width; ++x) row[x / tile_size] += value(i++);
    }
}

} // namespace raylab
