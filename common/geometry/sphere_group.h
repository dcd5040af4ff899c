// Up to sixteen spheres side by side, and a first glance at all of them at once: as quad_group.h.
//
// A ray misses most spheres of a heap. The exact test is in double (sphere.h). Float is enough to
// see that the ray passes far from a sphere, for sixteen spheres with a few vector instructions. A
// glance may keep a sphere that the ray just misses; it never drops a sphere that the ray meets.
#pragma once

#include "common/geometry/ray.h"

#include <cstdint>

namespace raylab {

constexpr int spheres_per_group = 16;

struct SphereGroup {
    int first, count; // SceneView::spheres[first .. first + count) in lanes 0 .. count - 1
    float extent;     // at least |coordinate| + radius of every sphere
    float center[3][spheres_per_group];
    float radius[spheres_per_group];
};

// Up to this number of spheres, testing all of them is as fast as a glance.
constexpr int few_spheres = 4;

//[ withhold 01
// A bit for each lane whose sphere `ray` may meet in (0, t_max].
//
// f is the vector from the centre to the origin. The line is nearest to the centre at t = -f.d /
// d.d, at the distance |f + t d|. M = max |o| + extent bounds |f| on every axis, so |f| and |t| are
// below sqrt(3) M. The bounds on the errors are (Higham, section 3.1):
//   2 u M   on each axis of f, with the rounding of the centre,
//   20 u M  for t = -f.d: 9 u M, and the missing division by d.d, which is 1 up to 6 u,
//   33 u M  for f + t d,
//   39 u M  with the rounding of its length, of the radius and of the sum.
// The code takes 64 u M. A comparison with NaN is false, and the lane is then kept. Below the
// normal numbers the error of a square is 2^-149; `underflow` covers it.
HD_HOT std::uint32_t glance(const SphereGroup& group, const Ray& ray, float t_max) {
    constexpr float u = unit_roundoff, underflow = 0x1p-140f;
    const Vec3 o = ray.o, d = ray.d;
    const float margin = 64 * u * (max_component(abs(o)) + group.extent);
    std::uint32_t maybe = 0;
    for (int k = 0; k < spheres_per_group; ++k) {
        const float fx = o.x - group.center[0][k], fy = o.y - group.center[1][k],
                    fz = o.z - group.center[2][k];
        const float middle = -(fx * d.x + fy * d.y + fz * d.z);
        const float nx = fx + middle * d.x, ny = fy + middle * d.y, nz = fz + middle * d.z;
        const float within = group.radius[k] + margin;
        const bool missed = (nx * nx + ny * ny + nz * nz > within * within + underflow) |
                            (middle + within < 0) | (middle - within > t_max) | (k >= group.count);
        maybe |= std::uint32_t(!missed) << k;
    }
    return maybe;
}
//]

} // namespace raylab
