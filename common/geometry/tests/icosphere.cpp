// A sphere of triangles: an icosahedron whose faces are split in four, `level` times.
#include "common/geometry/tests/support.h"

#include <map>

namespace raylab::test {

Mesh icosphere(int level, double radius, DVec3 center) {
    const double g = 1.6180339887498948482; // golden ratio
    std::vector<DVec3> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                 {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                 {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    for (DVec3& p : points) p = glm::normalize(p);
    std::vector<std::array<int, 3>> faces = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};

    for (int i = 0; i < level; ++i) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), int(points.size()));
            if (is_new) points.push_back(glm::normalize(points[a] + points[b]));
            return at->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }

    Mesh mesh{{}, std::move(faces), {}};
    for (const DVec3& p : points) mesh.vertices.push_back(Vec3(center + radius * p));
    mesh.faces_at.resize(points.size());
    for (int f = 0; f < int(mesh.faces.size()); ++f)
        for (int v : mesh.faces[f]) mesh.faces_at[v].push_back(f);
    return mesh;
}

} // namespace raylab::test
