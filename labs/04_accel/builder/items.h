// What builders sort: the box of each triangle.
#pragma once

#include "common/geometry/shapes.h"

#include <cmath>
#include <vector>

namespace raylab::lab04 {

struct BuildItem {
    Bounds box;
    int index; // in the scene's triangles

    // Twice the centre of the box: what is compared need not be halved.
    float centre(int axis) const { return box.low[axis] + box.high[axis]; }
};

// Half the surface of a box. The chance that a random ray crosses the box is proportional to it.
inline double half_area(const Bounds& box) {
    const double x = double(box.high.x) - box.low.x, y = double(box.high.y) - box.low.y,
                 z = double(box.high.z) - box.low.z;
    return x * y + y * z + z * x;
}

// One item for each triangle with finite corners.
inline std::vector<BuildItem> build_items(const std::vector<Triangle>& triangles) {
    std::vector<BuildItem> items;
    items.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        BuildItem item{{}, static_cast<int>(i)};
        bool finite = true;
        for (const Vec3& v : triangles[i].v) {
            item.box.include(v);
            finite = finite && std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
        }
        if (finite) items.push_back(item);
    }
    return items;
}

} // namespace raylab::lab04
