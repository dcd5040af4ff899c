// A sphere flake: on every sphere sit spheres of a third of its radius, on those others (E. Haines,
// "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987). Here a sphere carries
// the twelve neighbours that it would have in the closest packing, less the one towards its parent:
// their directions need no rotation, and no two spheres meet. The first sphere is the unit sphere,
// the whole reaches to 2. The last level is incomplete; the seed chooses which spheres it has.
#include "common/load/procedural/parts.h"
#include "common/load/procedural/procedural.h"

#include <cmath>

namespace raylab {
namespace {

struct Ball {
    DVec3 center;
    double radius;
    DVec3 outward; // from its parent, of length sqrt(2); 0 for the first
};

// The corners of a cuboctahedron, of length sqrt(2).
std::vector<DVec3> neighbours() {
    std::vector<DVec3> directions;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {-1, 1})
            for (const double b : {-1, 1}) {
                DVec3 d(0);
                d[(axis + 1) % 3] = a;
                d[(axis + 2) % 3] = b;
                directions.push_back(d);
            }
    return directions;
}

std::vector<Ball> children_of(const std::vector<Ball>& parents) {
    const std::vector<DVec3> directions = neighbours();
    std::vector<Ball> children;
    for (const Ball& parent : parents)
        for (const DVec3& d : directions)
            if (dot(d, parent.outward) > -2) { // -2: straight back
                const double radius = parent.radius / 3;
                const double distance = (parent.radius + radius) / std::sqrt(2.0);
                children.push_back({parent.center + distance * d, radius, d});
            }
    return children;
}

} // namespace

Mesh make_sphere_flake(int triangles, std::uint32_t seed) {
    // More spheres and finer ones: both numbers grow with the square root of the triangles'.
    int f = 2;
    while (100LL * (f + 1) * (f + 1) * (f + 1) * (f + 1) <= triangles) ++f;
    int room = triangles / (8 * f * f); // spheres yet to come
    Mesh mesh;
    for (std::vector<Ball> level = {{DVec3(0), 1, DVec3(0)}}; room > 0;
         level = children_of(level)) {
        const int n = int(level.size()), count = std::min(n, room);
        const std::vector<bool> is_there = chosen(count, n, seed);
        for (int i = 0; i < n; ++i)
            if (is_there[std::size_t(i)])
                add_sphere(mesh, level[std::size_t(i)].center, level[std::size_t(i)].radius, f);
        room -= count;
    }
    return mesh;
}

} // namespace raylab
