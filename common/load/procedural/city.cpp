// An axis-aligned city: boxes on lots of a grid, wall to wall in squares of four by four lots, with
// streets between the squares. Every coordinate is a whole number: walls of neighbours lie in one
// plane and over each other, roofs of one height and all floors (y = 0) are coplanar, edges fall
// together, and rays along an axis run in walls. On one lot in eight the box is flat: floor and
// roof are one square, seen from two sides.
#include "common/load/procedural/parts.h"
#include "common/load/procedural/procedural.h"
#include "common/sampling/hash.h"

namespace raylab {
namespace {

// Two triangles; counterclockwise.
void add_square(Mesh& mesh, int a, int b, int c, int d) {
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
}

void add_box(Mesh& mesh, int x, int z, int height) {
    int corner[8]; // bit 0: x is high; bit 1: y; bit 2: z
    for (int i = 0; i < 8; ++i)
        corner[i] = add_position(mesh, DVec3(x + (i & 1), i & 2 ? height : 0, z + (i >> 2)));
    const auto square = [&](int a, int b, int c, int d) {
        add_square(mesh, corner[a], corner[b], corner[c], corner[d]);
    };
    square(0, 4, 6, 2);
    square(1, 3, 7, 5);
    square(0, 1, 5, 4);
    square(2, 6, 7, 3);
    square(0, 2, 3, 1);
    square(4, 5, 7, 6);
}

void add_flat_box(Mesh& mesh, int x, int z) {
    int corner[4];
    for (int i = 0; i < 4; ++i) corner[i] = add_position(mesh, DVec3(x + (i & 1), 0, z + (i >> 1)));
    add_square(mesh, corner[0], corner[1], corner[3], corner[2]); // floor, seen from below
    add_square(mesh, corner[0], corner[2], corner[3], corner[1]); // roof
}

} // namespace

Mesh make_city(int triangles, std::uint32_t seed) {
    int side = 1; // lots along x
    while (12LL * (side + 1) * (side + 1) <= triangles) ++side;
    const auto place = [](int lot) { return lot + lot / 4; }; // a street behind each fourth
    Mesh mesh;
    for (int lot = 0; int(mesh.triangles.size()) + 12 <= triangles; ++lot) {
        const int i = lot % side, j = lot / side;
        const Words random = pcg4d({seed, std::uint32_t(i), std::uint32_t(j), 0});
        // Mostly low, some towers: the lesser of two throws, 1 to 8.
        const int height = 1 + int(std::min(random.x >> 29, random.y >> 29));
        if (random.z >> 29 == 0)
            add_flat_box(mesh, place(i), place(j));
        else
            add_box(mesh, place(i), place(j), height);
    }
    return mesh;
}

} // namespace raylab
