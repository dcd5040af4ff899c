// Boxes around spheres and quads, and their order in the scene's arrays.
#pragma once

#include "common/geometry/shapes.h"

#include <vector>

namespace raylab {

// The box around a shape, and room for what the tests of shapes leave open: where they find the
// ray on the shape, it is within 2^-24 of the largest coordinate.
Bounds box_around(const Sphere& sphere);
Bounds box_around(const Quad& quad);

// Sorts the shapes so that those of one group (sphere_groups.h, quad_groups.h) lie together. Halves
// of halves of the array are halves in space, so that a tree over groups need but count
// (labs/04_accel/shapes/tree.h).
void sort_into_groups(std::vector<Sphere>& spheres);
void sort_into_groups(std::vector<Quad>& quads);

} // namespace raylab
