// Long thin triangles at every slant, 64 times as long as wide, with their feet in the unit cube.
// Their boxes are as wide as they are long, so that boxes overlap however they are put together.
// Length goes with 1 / cbrt(triangles): each point of the cube lies in about as many boxes whatever
// their number.
#include "common/load/procedural/parts.h"
#include "common/load/procedural/procedural.h"
#include "common/sampling/hash.h"

#include <cmath>

namespace raylab {
namespace {

DVec3 unit_cube_point(Words w) { return DVec3(w.x, w.y, w.z) * 0x1p-32; }

// Evenly among all directions: the first of a row of points in [-1, 1]^3 that lies in the shell.
DVec3 random_direction(std::uint32_t seed, std::uint32_t i, std::uint32_t purpose) {
    for (std::uint32_t attempt = purpose;; attempt += 4) {
        const DVec3 d = 2.0 * unit_cube_point(pcg4d({seed, i, attempt, 0})) - 1.0;
        const double square = dot(d, d);
        if (square > 0.01 && square < 1) return d / std::sqrt(square);
    }
}

} // namespace

Mesh make_needles(int triangles, std::uint32_t seed) {
    int root = 1; // of the number, cubic, rounded down
    while ((root + 1LL) * (root + 1) * (root + 1) <= triangles) ++root;
    const double length = 4.0 / root, half_width = length / 128;
    Mesh mesh;
    for (std::uint32_t i = 0; i < std::uint32_t(triangles); ++i) {
        const DVec3 foot = unit_cube_point(pcg4d({seed, i, 0, 0}));
        const DVec3 along = random_direction(seed, i, 1), other = random_direction(seed, i, 2);
        const DVec3 aside = other - dot(other, along) * along; // `other` less its part along
        const DVec3 across = aside * (half_width / std::sqrt(dot(aside, aside)));
        const int a = add_position(mesh, foot - across), b = add_position(mesh, foot + across),
                  tip = add_position(mesh, foot + length * along);
        add_triangle(mesh, a, b, tip);
    }
    return mesh;
}

} // namespace raylab
