// Where to cut a cell: the surface area heuristic.
// MacDonald and Booth, Heuristics for Ray Tracing Using Space Subdivision, 1990; Wald and Havran
// 2006.
//
// Of the rays that enter a cell, the share area(part) / area(cell) enters a convex part of it,
// where area is that of the surface. So a ray through a cell that is cut into L and R takes about
// as long as
//     cost = step + (area(L) packs(L) + area(R) packs(R)) / area(cell)
// tests of packs. If the cell stays a leaf, it takes packs(cell) of them. The best plane lies where
// a triangle begins or ends: between two such places the counts do not change, and the cost is
// linear in the plane's place.
#pragma once

#include "labs/04_accel/builder/clip.h"
#include "labs/04_accel/leaf/triangle_pack.h"

#include <span>

namespace raylab::lab04 {

// Both are measured. With a cheaper step the tree gets so large that it leaves the caches, and this
// costs more than the tests that it saves.
struct KdCosts {
    double step = 2; // of going down a node, in tests of packs
    // Times the cost of a plane with no triangle on one side: a ray passes an empty cell quickly.
    double empty_factor = 0.9;
};

struct KdPlane {
    int axis = -1; // -1: there is none
    float at = 0;
    double cost = infinity; // of a ray through the cell
};

// The plane of least cost strictly inside the cell. Of few triangles it tries every place where one
// begins or ends; of many it tries, on each axis, 31 places at even distances, the place where the
// first triangle begins and the place where the last one ends.
KdPlane best_plane(std::span<const KdReference> references, const Bounds& cell,
                   const KdCosts& costs);

} // namespace raylab::lab04
