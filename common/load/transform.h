// An affine transform of a shape, in double; applied once, at load time.
#pragma once

#include "common/math/vec.h"

namespace raylab {

// p -> linear * p + translation.
struct Transform {
    glm::dmat3 linear = glm::dmat3(1);
    DVec3 translation = DVec3(0);

    DVec3 point(DVec3 p) const { return linear * p + translation; }

    // Tangents transform by M; a normal must stay orthogonal to them, n . t = 0, so it transforms
    // by the inverse transpose: (M^-T n) . (M t) = n . t. Mirrored or not, it stays on the same
    // side of the surface. Not normalised.
    DVec3 normal(DVec3 n) const { return glm::transpose(glm::inverse(linear)) * n; }

    // A mirrored shape's vertices change their sense of rotation, and with it the normal that their
    // order defines: the loader swaps two of them to keep it outward.
    bool mirrors() const { return glm::determinant(linear) < 0; }

    // First inner, then outer.
    friend Transform operator*(const Transform& outer, const Transform& inner) {
        return {outer.linear * inner.linear, outer.point(inner.translation)};
    }
};

// Rotation by an angle about a unit axis, counterclockwise seen against the axis (Rodrigues).
inline glm::dmat3 rotation(DVec3 axis, double radians) {
    const double c = std::cos(radians), s = std::sin(radians);
    const glm::dmat3 cross_product(0, axis.z, -axis.y, -axis.z, 0, axis.x, axis.y, -axis.x, 0);
    return c * glm::dmat3(1) + s * cross_product + (1 - c) * glm::outerProduct(axis, axis);
}

} // namespace raylab
