#include "common/load/procedural/parts.h"

#include "common/sampling/hash.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace raylab {

int add_position(Mesh& mesh, DVec3 position) {
    mesh.positions.push_back(DVec3(Vec3(position)));
    return int(mesh.positions.size()) - 1;
}

void add_triangle(Mesh& mesh, int a, int b, int c) {
    MeshTriangle triangle;
    triangle.position = {a, b, c};
    mesh.triangles.push_back(triangle);
}

// The `count` with the least hashes; of equal hashes the lower number.
std::vector<bool> chosen(int count, int n, std::uint32_t seed) {
    std::vector<std::pair<std::uint32_t, int>> lots;
    for (int i = 0; i < n; ++i) lots.emplace_back(pcg4d({seed, std::uint32_t(i), 0, 0}).x, i);
    std::nth_element(lots.begin(), lots.begin() + count, lots.end());
    std::vector<bool> flags(std::size_t(n), false);
    for (int i = 0; i < count; ++i) flags[std::size_t(lots[i].second)] = true;
    return flags;
}

// The octahedron |x| + |y| + |z| = f has its lattice points where x, y and z are whole. Each octant
// is a face; neighbours share the points of their common edge.
void add_sphere(Mesh& mesh, DVec3 center, double radius, int f) {
    const int side = 2 * f + 1;
    std::vector<int> known(std::size_t(2 * side * side), -1); // [z < 0][y][x]
    const auto point = [&](int x, int y, int z) {
        int& index = known[std::size_t(((z < 0) * side + y + f) * side + x + f)];
        if (index < 0) {
            const DVec3 p(x, y, z);
            index = add_position(mesh, center + p * (radius / std::sqrt(dot(p, p))));
        }
        return index;
    };
    for (int octant = 0; octant < 8; ++octant) {
        const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
        const bool mirrored = sx * sy * sz < 0;
        const auto corner = [&](int a, int b) {
            return point(sx * a, sy * b, sz * (f - std::abs(a) - std::abs(b)));
        };
        const auto face = [&](int a, int b, int c) {
            mirrored ? add_triangle(mesh, a, c, b) : add_triangle(mesh, a, b, c);
        };
        for (int a = 0; a < f; ++a)
            for (int b = 0; a + b < f; ++b) {
                face(corner(a, b), corner(a + 1, b), corner(a, b + 1));
                if (a + b + 1 < f) face(corner(a + 1, b), corner(a + 1, b + 1), corner(a, b + 1));
            }
    }
}

} // namespace raylab
