// Axis-aligned boxes, and a slab test that misses no box which the ray crosses.
// Williams et al., An Efficient and Robust Ray-Box Intersection Algorithm, 2005;
// Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013.
#pragma once

#include "common/geometry/ray.h"
#include "common/math/along.h"

namespace raylab {

struct Bounds {
    Vec3 low = Vec3(infinity);
    Vec3 high = Vec3(-infinity);

    HD void include(Vec3 p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    HD void include(const Bounds& b) {
        low = glm::min(low, b.low);
        high = glm::max(high, b.high);
    }
};

// A ray prepared for slab tests: 1/d, and which face of a box is the near one on each axis.
struct SlabRay {
    Vec3 o;
    Vec3 inv_d;
    bool negative[3];

    HD explicit SlabRay(const Ray& ray) : o(ray.o), inv_d(1.0f / ray.d) {
        for (int axis = 0; axis < 3; ++axis)
            negative[axis] = along(inv_d, axis) < 0; // 1 / -0 = -inf
    }
};

// Does the ray cross the box within [0, t_max]? The answer for a near miss may be yes; the answer
// for a hit is never no.
//
// The sign of d chooses the near and the far face. min and max of the two t would fail for a ray
// that lies in a face, where 0 * inf = NaN. A comparison with NaN is false, so here the interval
// stays as it is. Each t = (face - o) * inv_d has three roundings, so t_far is enlarged by the
// errors of both t, 2 gamma(3).
HD bool crosses(const Bounds& box, const SlabRay& ray, float t_max) {
    float t_near = 0, t_far = t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const bool negative = ray.negative[axis];
        const float o = along(ray.o, axis), inv_d = along(ray.inv_d, axis);
        const float low = along(box.low, axis), high = along(box.high, axis);
        const float near_t = ((negative ? high : low) - o) * inv_d;
        const float far_t = ((negative ? low : high) - o) * inv_d;
        if (near_t > t_near) t_near = near_t;
        if (far_t < t_far) t_far = far_t;
    }
    return t_near <= t_far * (1 + 2 * gamma_bound(3));
}

} // namespace raylab
