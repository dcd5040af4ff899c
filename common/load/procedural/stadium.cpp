// The teapot in a stadium (E. Haines's name for it): a structure that cuts space evenly sees all of
// the detail in one cell. The stadium is a round bowl of at most a quarter of the triangles and at
// most 1056, radius 512 to 1024, open above; in it stands a sphere flake of radius 2, off the
// middle.
#include "common/load/procedural/parts.h"
#include "common/load/procedural/procedural.h"

#include <cmath>

namespace raylab {
namespace {

constexpr int most_steps = 8;

// The field is a fan; a step has a tread and a riser, each a band around.
int bowl_triangles(int steps) { return 4 * steps * (1 + 4 * steps); }

// Around the axis, with steps of seats on 4 steps sides.
void add_bowl(Mesh& mesh, int steps) {
    const int sides = 4 * steps;
    const auto ring = [&](double radius, double y) {
        const int first = int(mesh.positions.size());
        for (int quarter = 0; quarter < 4; ++quarter)
            for (int i = 0; i < steps; ++i) {
                const double s = double(i) / steps; // along the side of a square
                const double scale = radius / std::sqrt(s * s + (1 - s) * (1 - s));
                double x = (1 - s) * scale, z = s * scale;
                for (int turn = 0; turn < quarter; ++turn) {
                    const double before = x;
                    x = -z, z = before;
                }
                add_position(mesh, DVec3(x, y, z));
            }
        return first;
    };
    const int middle = add_position(mesh, DVec3(0));
    int inner = ring(512, 0);
    for (int i = 0; i < sides; ++i) add_triangle(mesh, middle, inner + (i + 1) % sides, inner + i);
    for (int band = 0; band < 2 * steps; ++band) {
        const int treads = band / 2 + 1, risers = (band + 1) / 2;
        const int outer = ring(512 + 512.0 * treads / steps, 256.0 * risers / steps);
        for (int i = 0; i < sides; ++i) {
            const int next = (i + 1) % sides;
            add_triangle(mesh, inner + i, inner + next, outer + i);
            add_triangle(mesh, inner + next, outer + next, outer + i);
        }
        inner = outer;
    }
}

} // namespace

Mesh make_stadium(int triangles, std::uint32_t seed) {
    int steps = 1;
    while (steps < most_steps && 4 * bowl_triangles(steps + 1) <= triangles) ++steps;
    Mesh mesh = make_sphere_flake(triangles - bowl_triangles(steps), seed);
    for (DVec3& p : mesh.positions) p = DVec3(Vec3(p + DVec3(5, 2, -3)));
    add_bowl(mesh, steps);
    return mesh;
}

} // namespace raylab
