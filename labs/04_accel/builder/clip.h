// Boxes around the part of a triangle that lies in a cell: these are what the builder of a KD-tree
// sorts. Wald and Havran 2006, section 4.4 ("perfect splits"). The box of the whole triangle will
// not do, since a slanted triangle is in few of the cells that its box is in (Havran, Heuristic Ray
// Shooting Algorithms, 2000).
#pragma once

#include "common/geometry/bounds.h"
#include "common/geometry/shapes.h"

#include <cmath>
#include <vector>

namespace raylab::lab04 {

// A triangle in a cell. box: it contains the part of the triangle that lies in the cell or within
// the margin of it, and is larger by the margin on all sides. A child holds the triangle if this
// box reaches into the child. So a triangle that only touches the plane is on both sides of it, and
// no box is flat.
struct KdReference {
    Bounds box;
    int triangle;
};

class KdClip {
  public:
    // largest: of the scene's coordinates. The margin is 2^-40 of it, room for the rounding in
    // walks (kd/ray.h). Boxes are widened by twice the margin and rounded outwards to float.
    explicit KdClip(float largest) : margin_(0x1p-40 * largest) {}

    Bounds whole(const Triangle& triangle) const {
        DBox box;
        for (const Vec3& v : triangle.v) box.include(DVec3(v));
        return widened(box);
    }

    // Cuts the part in `box` at a plane across the axis; either side may come out empty.
    void cut(const Triangle& triangle, const Bounds& box, int axis, float plane, Bounds& below,
             Bounds& above) const {
        DBox low, high;
        const double low_end = plane + margin_, high_begin = plane - margin_;
        for (int i = 0; i < 3; ++i) {
            const DVec3 a(triangle.v[i]), b(triangle.v[i == 2 ? 0 : i + 1]);
            if (a[axis] <= low_end) low.include(a);
            if (a[axis] >= high_begin) high.include(a);
            if ((a[axis] < low_end) != (b[axis] < low_end)) low.include(on(a, b, axis, low_end));
            if ((a[axis] < high_begin) != (b[axis] < high_begin))
                high.include(on(a, b, axis, high_begin));
        }
        below = common(widened(low), box);
        above = common(widened(high), box);
    }

  private:
    struct DBox {
        DVec3 low{HUGE_VAL}, high{-HUGE_VAL};
        void include(DVec3 p) { low = glm::min(low, p), high = glm::max(high, p); }
    };

    // Where the edge from a to b meets the plane; off by at most 2^-50 of the coordinates.
    static DVec3 on(DVec3 a, DVec3 b, int axis, double plane) {
        DVec3 p = a + (b - a) * ((plane - a[axis]) / (b[axis] - a[axis]));
        p[axis] = plane;
        return p;
    }
    static float round_down(double x) {
        const float f = float(x);
        return f > x ? std::nextafter(f, -infinity) : f;
    }
    Bounds widened(const DBox& box) const {
        Bounds wide;
        for (int axis = 0; axis < 3; ++axis) {
            wide.low[axis] = round_down(box.low[axis] - 2 * margin_);
            wide.high[axis] = -round_down(-box.high[axis] - 2 * margin_);
        }
        return wide;
    }
    static Bounds common(const Bounds& a, const Bounds& b) {
        return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
    }

    double margin_;
};

inline bool is_empty(const Bounds& box) {
    return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
}

} // namespace raylab::lab04
