// A ray and what it hit.
#pragma once

#include "common/math/numbers.h"
#include "common/math/vec.h"

namespace raylab {

// The half line o + t d, 0 < t < t_max. d is a unit vector, so t is a distance.
struct Ray {
    Vec3 o;
    Vec3 d;
    float t_max = infinity;

    HD Vec3 operator()(float t) const { return o + t * d; }
};

enum class Shape : int { none, sphere, quad, plane, triangle };

// The closest hit so far. `index` counts within the arrays of its shape; `id` counts over the whole
// scene in file order. It breaks ties: of two hits at the same t, the hit with the lower id wins.
// So neither the order of tests nor an acceleration structure changes an image.
struct Hit {
    float t = infinity;
    int id = -1;
    Shape shape = Shape::none;
    int index = -1;

    HD bool found() const { return shape != Shape::none; }

    HD bool is_beaten_by(float t_other, int id_other) const {
        return t_other < t || (t_other == t && id_other < id);
    }
};

} // namespace raylab
