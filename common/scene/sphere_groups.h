// Laying spheres out side by side, for the glance of common/geometry/sphere_group.h.
#pragma once

#include "common/geometry/shapes.h"
#include "common/geometry/sphere_group.h"

#include <vector>

namespace raylab {

// Spheres in their order, sixteen a group. Whoever changes a scene's spheres calls this again.
std::vector<SphereGroup> group_spheres(const std::vector<Sphere>& spheres);

} // namespace raylab
