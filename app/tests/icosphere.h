// A closed mesh built in code: an icosahedron whose faces are split in four, `level` times.
#pragma once

#include "common/load/scene_builder.h"
#include "common/scene/scene.h"
#include "common/scene/triangle_runs.h"

#include <array>
#include <map>

namespace raylab::app {

struct Icosphere {
    std::vector<DVec3> points; // unit
    std::vector<std::array<int, 3>> faces;
};

inline Icosphere icosphere(int level) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    Icosphere mesh{{{-1, g, 0},
                    {1, g, 0},
                    {-1, -g, 0},
                    {1, -g, 0},
                    {0, -1, g},
                    {0, 1, g},
                    {0, -1, -g},
                    {0, 1, -g},
                    {g, 0, -1},
                    {g, 0, 1},
                    {-g, 0, -1},
                    {-g, 0, 1}},
                   {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
    for (DVec3& p : mesh.points) p = glm::normalize(p);
    for (int i = 0; i < level; ++i) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [at, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.points.size()));
            if (is_new) mesh.points.push_back(glm::normalize(mesh.points[a] + mesh.points[b]));
            return at->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : mesh.faces) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.faces = std::move(finer);
    }
    return mesh;
}

// Adds the mesh to a scene as the loader would, with ids behind those that are there.
inline void add_icosphere(Scene& scene, int level, double radius, int material, bool smooth) {
    int id = static_cast<int>(scene.spheres.size() + scene.quads.size() + scene.planes.size() +
                              scene.triangles.size());
    const int first = static_cast<int>(scene.triangles.size());
    const Icosphere mesh = icosphere(level);
    for (const std::array<int, 3>& face : mesh.faces) {
        Triangle triangle{{}, {}, -1, {id++, material, -1}};
        TriangleCorners corners{};
        for (int i = 0; i < 3; ++i) {
            triangle.v[i] = Vec3(radius * mesh.points[face[i]]);
            corners.normal[i] = Vec3(mesh.points[face[i]]);
        }
        set_normal(triangle);
        if (smooth) {
            triangle.corners = static_cast<int>(scene.corners.size());
            scene.corners.push_back(corners);
        }
        scene.triangles.push_back(triangle);
    }
    cut_into_runs(scene.triangles, first, scene.runs);
}

} // namespace raylab::app
