// Where to cut a node in two: between its triangles, or through them.
//
// Both ask the surface area heuristic: after a cut a ray costs, in expectation,
//     A_left / A * packs(n_left) + A_right / A * packs(n_right).
// Cutting *between* triangles sorts them by their centres into slices (Wald, On Fast Construction
// of SAH-based Bounding Volume Hierarchies, 2007). The boxes of long slanted triangles overlap,
// however the triangles are sorted. Then a plane *through* triangles may be better: each side has a
// box around its part of the triangle alone. The price is a second reference to the triangle
// (Stich, Friedrich and Dietrich, Spatial Splits in Bounding Volume Hierarchies, HPG 2009).
#pragma once

#include "labs/04_accel/builder/clip.h"
#include "labs/04_accel/builder/items.h"

#include <span>
#include <vector>

namespace raylab::lab04 {

struct Split {
    double cost = infinity; // times A
    int axis = -1;          // -1: there is no such cut
    int plane = 0;          // of a cut between: the slices before this one go left
    float position = 0;     // of a cut through: where on the axis the plane is
    double overlap = 0; // of a cut between: half the surface of what both children's boxes cover
};

using Items = std::span<BuildItem>;

// The box around the items' centres, times two as BuildItem::centre(). Slices divide this box.
Bounds centres_of(std::span<const BuildItem> items);

Split best_cut_between(std::span<const BuildItem> items, const Bounds& centres);
// Moves those that go left to the front; returns how many.
std::size_t cut_between(Items items, const Bounds& centres, const Split& split);

// The best one that costs less than most_cost; axis -1: none does.
Split best_cut_through(std::span<const BuildItem> items, const Bounds& box,
                       const std::vector<Triangle>& triangles, double most_cost);
// References that a cut through leaves on the left and on the right.
void cut_through(std::span<const BuildItem> items, const std::vector<Triangle>& triangles,
                 const KdClip& clip, const Split& split, std::vector<BuildItem>& left,
                 std::vector<BuildItem>& right);

} // namespace raylab::lab04
