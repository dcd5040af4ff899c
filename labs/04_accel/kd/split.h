// Where to cut a cell: the surface area heuristic.
// MacDonald and Booth, Heuristics for Ray Tracing Using Space Subdivision, 1990; Wald and Havran
// 2006.
//
// Of the rays that come into a cell, a share in proportion to its surface comes into a part of it.
// So a ray through a cell that is cut into L and R takes about the time of
//     cost = step + (area(L) packs(L) + area(R) packs(R)) / area(cell)
// pack tests, and of packs(cell) if the cell stays a leaf. The best plane lies where a triangle
// begins or ends: between two such places the counts stay and the cost is linear.
#pragma once

#include "labs/04_accel/builder/clip.h"
#include "labs/04_accel/leaf/triangle_pack.h"

#include <span>

namespace raylab::lab04 {

// Measured: with cheaper steps the tree grows out of the caches before it saves tests.
struct KdCosts {
    double step = 2;           // of going down a node, in pack tests
    double empty_factor = 0.9; // on a plane with nothing on one side: nothing is passed quickly
};

struct KdPlane {
    int axis = -1; // -1: there is none
    float at = 0;
    double cost = infinity; // of a ray through the cell
};

// The plane of least cost strictly inside the cell. Few triangles: every place where one begins or
// ends. Many: 31 places an axis at even distances, and where all begin and all end.
KdPlane best_plane(std::span<const KdReference> references, const Bounds& cell,
                   const KdCosts& costs);

} // namespace raylab::lab04
