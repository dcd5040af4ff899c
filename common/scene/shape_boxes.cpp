#include "common/scene/shape_boxes.h"

#include "common/geometry/quad_group.h"
#include "common/geometry/sphere_group.h"
#include "common/scene/halving.h"

namespace raylab {
namespace {

// In double: no overflow.
struct ExactBox {
    DVec3 low, high;
};

ExactBox exact_box(const Sphere& sphere) {
    const DVec3 center(sphere.center), radius(sphere.radius);
    return {center - radius, center + radius};
}

ExactBox exact_box(const Quad& quad) {
    ExactBox box{DVec3(quad.v[0]), DVec3(quad.v[0])};
    for (const Vec3& v : quad.v) {
        box.low = glm::min(box.low, DVec3(v));
        box.high = glm::max(box.high, DVec3(v));
    }
    return box;
}

// Rounding to float takes at most a quarter of the room.
Bounds with_room(const ExactBox& box) {
    const DVec3 size = glm::max(glm::abs(box.low), glm::abs(box.high));
    const DVec3 room(4 * unit_roundoff * glm::max(glm::max(size.x, size.y), size.z));
    return {Vec3(box.low - room), Vec3(box.high + room)};
}

template <class T> void sort_into_runs(std::vector<T>& shapes, int run) {
    halve_into_runs(shapes.begin(), shapes.end(), run, [](const T& shape, int axis) {
        const ExactBox box = exact_box(shape);
        return box.low[axis] + box.high[axis];
    });
}

} // namespace

Bounds box_around(const Sphere& sphere) { return with_room(exact_box(sphere)); }
Bounds box_around(const Quad& quad) { return with_room(exact_box(quad)); }

void sort_into_groups(std::vector<Sphere>& spheres) { sort_into_runs(spheres, spheres_per_group); }
void sort_into_groups(std::vector<Quad>& quads) { sort_into_runs(quads, quads_per_group); }

} // namespace raylab
