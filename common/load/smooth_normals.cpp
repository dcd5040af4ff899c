// Smooth normals for a mesh that comes without.
#include "common/load/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raylab {
namespace {

// The angle between two vectors; atan2 is exact to rounding for small and for flat angles, where
// acos of a dot product loses half the digits.
double angle_between(DVec3 a, DVec3 b) {
    const DVec3 n = cross(a, b);
    return std::atan2(std::sqrt(dot(n, n)), dot(a, b));
}

// For each position the lowest index of an equal one: corners that a file lists twice, say for
// two texture coordinates, are one point of the surface.
std::vector<int> welded(const std::vector<DVec3>& positions) {
    std::vector<int> order(positions.size()), representative(positions.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int i) {
        return std::array{positions[i].x, positions[i].y, positions[i].z};
    };
    const auto less = [&](int a, int b) { // non-finite positions are no points: keep them apart
        for (int axis = 0; axis < 3; ++axis) {
            const double x = key(a)[axis], y = key(b)[axis];
            if (std::isnan(x) != std::isnan(y)) return std::isnan(y);
            if (x < y || y < x) return x < y;
        }
        return a < b;
    };
    std::sort(order.begin(), order.end(), less);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
        representative[order[i]] = same ? representative[order[i - 1]] : order[i];
    }
    return representative;
}

} // namespace

void compute_smooth_normals(Mesh& mesh) {
    const std::vector<int> representative = welded(mesh.positions);
    const int first = int(mesh.normals.size());
    mesh.normals.resize(mesh.normals.size() + mesh.positions.size(), DVec3(0));
    for (MeshTriangle& triangle : mesh.triangles) {
        DVec3 p[3];
        int shared[3];
        for (int i = 0; i < 3; ++i) {
            p[i] = mesh.positions[triangle.position[i]];
            shared[i] = first + representative[triangle.position[i]];
        }
        if (triangle.normal[0] < 0) triangle.normal = {shared[0], shared[1], shared[2]};
        const DVec3 face = cross(p[1] - p[0], p[2] - p[0]);
        const double size = std::sqrt(dot(face, face));
        if (!(size > 0) || !std::isfinite(size)) continue; // will be dropped
        for (int i = 0; i < 3; ++i) {
            const double angle = angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
            mesh.normals[shared[i]] += face / size * angle;
        }
    }
}

} // namespace raylab
