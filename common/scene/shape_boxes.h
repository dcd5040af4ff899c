// Boxes around spheres and quads, and their order in the scene's arrays.
#pragma once

#include "common/geometry/shapes.h"

#include <vector>

namespace raylab {

// The box around a shape, with a margin for the error of the shape's test: the hit that a test
// finds is within 2^-24 of the largest coordinate of the shape.
Bounds box_around(const Sphere& sphere);
Bounds box_around(const Quad& quad);

// Sorts the shapes so that those of one group (sphere_groups.h, quad_groups.h) lie together. Each
// half of the array, and each half of a half, is a half in space. So a tree over the groups follows
// from their numbers alone (labs/04_accel/shapes/tree.h).
void sort_into_groups(std::vector<Sphere>& spheres);
void sort_into_groups(std::vector<Quad>& quads);

} // namespace raylab
