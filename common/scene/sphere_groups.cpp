#include "common/scene/sphere_groups.h"

#include <algorithm>

namespace raylab {

std::vector<SphereGroup> group_spheres(const std::vector<Sphere>& spheres) {
    std::vector<SphereGroup> groups;
    const int size = static_cast<int>(spheres.size());
    for (int first = 0; first < size; first += spheres_per_group) {
        SphereGroup& group = groups.emplace_back();
        group.first = first;
        group.count = std::min(spheres_per_group, size - first);
        for (int lane = 0; lane < group.count; ++lane) {
            const Sphere& sphere = spheres[first + lane];
            const Vec3 center(sphere.center);
            const float radius = static_cast<float>(sphere.radius);
            for (int axis = 0; axis < 3; ++axis) group.center[axis][lane] = center[axis];
            group.radius[lane] = radius;
            group.extent = std::max(group.extent, max_component(abs(center)) + radius);
        }
    }
    return groups;
}

} // namespace raylab
