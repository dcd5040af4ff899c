// A Sierpinski tetrahedron: a tetrahedron is replaced by four of half its size in its corners,
// which touch in points and leave half of its volume empty; without end, a surface of dimension 2
// (W. Sierpinski, 1915, in the plane). In the cube [0, 1]^3; every coordinate is a binary fraction,
// so corners that touch are equal to the bit. The last level reaches only some, which the seed
// chooses.
#include "common/load/procedural/parts.h"
#include "common/load/procedural/procedural.h"

namespace raylab {
namespace {

// Four corners of a cube, no two of them neighbours.
constexpr int corner[4][3] = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
constexpr int face[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}; // normals outward

struct Tetrahedron {
    DVec3 low; // corner of its cube
    double side;

    DVec3 point(int i) const {
        return low + side * DVec3(corner[i][0], corner[i][1], corner[i][2]);
    }
    Tetrahedron child(int i) const {
        const Tetrahedron half = {low, side / 2};
        return {half.point(i), side / 2};
    }
};

} // namespace

Mesh make_fractal(int triangles, std::uint32_t seed) {
    const int most = triangles / 4; // tetrahedra
    std::vector<Tetrahedron> level = {{DVec3(0), 1}};
    for (bool complete = true; complete;) {
        const int n = int(level.size()), refined = std::min(n, (most - n) / 3);
        complete = refined == n;
        const std::vector<bool> is_refined = chosen(refined, n, seed);
        std::vector<Tetrahedron> next;
        for (int i = 0; i < n; ++i)
            if (is_refined[std::size_t(i)])
                for (int k = 0; k < 4; ++k) next.push_back(level[std::size_t(i)].child(k));
            else
                next.push_back(level[std::size_t(i)]);
        level = std::move(next);
    }
    Mesh mesh;
    for (const Tetrahedron& t : level) {
        int index[4];
        for (int i = 0; i < 4; ++i) index[i] = add_position(mesh, t.point(i));
        for (const auto& f : face) add_triangle(mesh, index[f[0]], index[f[1]], index[f[2]]);
    }
    return mesh;
}

} // namespace raylab
