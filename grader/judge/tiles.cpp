// The geometry of tiles, and sums over regions that are made of them.
#include "grader/judge/tiles.h"

#include <algorithm>

namespace raylab {

std::vector<Region> regions_of(int width, int height, int size) {
    std::vector<Region> regions;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size)
            regions.push_back({x, y, std::min(x + size, width), std::min(y + size, height)});
    return regions;
}

Region parent_of(const Region& region, int size, int width, int height) {
    const int twice = 2 * size;
    const int x = region.x0 / twice * twice, y = region.y0 / twice * twice;
    return {x, y, std::min(x + twice, width), std::min(y + twice, height)};
}

DVec3 TileSums::over(const Region& region) const {
    DVec3 sum(0);
    for (int y = region.y0 / tile_size; y <= (region.y1 - 1) / tile_size; ++y)
        for (int x = region.x0 / tile_size; x <= (region.x1 - 1) / tile_size; ++x)
            sum += sums_[std::size_t(y) * std::size_t(columns_) + std::size_t(x)];
    return sum;
}

} // namespace raylab
