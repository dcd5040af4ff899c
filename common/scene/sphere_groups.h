// Laying spheres out side by side, for the glance of common/geometry/sphere_group.h.
#pragma once

#include "common/geometry/shapes.h"
#include "common/geometry/sphere_group.h"

#include <vector>

namespace raylab {

// Puts spheres into groups of sixteen, in their order. Call it again after a change of the spheres.
std::vector<SphereGroup> group_spheres(const std::vector<Sphere>& spheres);

} // namespace raylab
