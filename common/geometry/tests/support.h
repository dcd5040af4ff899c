// What the geometry tests share: random rays, small scenes, meshes, and the table of figures.
//
// A figure is one row of the suite of hard cases: what was measured of our code, the tolerance, and
// what the naive variant it guards against makes of the same input. A row fails if ours is out of
// tolerance, and also if the naive variant is within it: then the test would guard nothing.
#pragma once

#include "common/geometry/make_quad.h"
#include "common/scene/quad_groups.h"
#include "common/scene/sphere_groups.h"
#include "common/trace/intersect.h"
#include "common/trace/offset.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace raylab::test {

// Truth is computed in extended precision: 64 bits of mantissa on x86.
using Real = long double;
using RVec = glm::vec<3, Real>;

// PCG32 (O'Neill, 2014): the same numbers with every compiler.
struct Random {
    std::uint64_t state;

    explicit Random(std::uint64_t seed) : state(seed * 0x9e3779b97f4a7c15u + 1442695040888963407u) {
        bits();
    }

    std::uint32_t bits() {
        const std::uint64_t old = state;
        state = old * 6364136223846793005u + 1442695040888963407u;
        return std::rotr(std::uint32_t(((old >> 18u) ^ old) >> 27u), int(old >> 59u));
    }
    int below(int n) { return int(bits() % std::uint32_t(n)); }
    double uniform() { return bits() * 0x1p-32; } // [0, 1)
    double between(double a, double b) { return a + (b - a) * uniform(); }

    // Uniform in the ball, then on the sphere: without libm, so that all machines agree.
    DVec3 unit() {
        for (;;) {
            const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
            const DVec3 v(x, y, z);
            if (dot(v, v) <= 1 && dot(v, v) > 1e-4) return glm::normalize(v);
        }
    }
    Vec3 direction() { return Vec3(unit()); }

    // Cosine-distributed about n: a uniform point on the sphere that rests on the surface.
    Vec3 cosine_direction(Vec3 n) { return Vec3(glm::normalize(DVec3(n) * (1 + 1e-9) + unit())); }
};

// Rays to shoot: `quick`, or all of the table's count when RAYLAB_LONG is set.
inline int rays(int quick, int full) { return std::getenv("RAYLAB_LONG") ? full : quick; }

inline void figure(const char* name, const std::string& what, double ours, double tolerance,
                   std::optional<double> naive = {}) {
    char other[32] = "";
    if (naive) std::snprintf(other, sizeof other, "naive %.3g", *naive);
    std::printf("  %-13s %-58s %-9.3g <= %-9.3g %s\n", name, what.c_str(), ours, tolerance, other);
    EXPECT_LE(ours, tolerance) << name << ": " << what;
    if (naive) {
        EXPECT_GT(*naive, tolerance) << name << ": the naive variant passes: " << what;
    }
}

// A figure that is reported and has no tolerance.
inline void note(const char* name, const std::string& what, double ours, double naive) {
    std::printf("  %-13s %-58s %-9.3g    %-9s naive %.3g\n", name, what.c_str(), ours, "", naive);
}

inline std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }

inline bool same_bits(Vec3 a, Vec3 b) {
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

inline bool same_hit(const Hit& a, const Hit& b) {
    return bits(a.t) == bits(b.t) && a.id == b.id && a.shape == b.shape;
}

// --- Scenes -----------------------------------------------------------------------------------

constexpr Features all_shapes =
    feature::sphere | feature::quad | feature::plane | feature::triangle;

inline Quad make_quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return raylab::make_quad({a, b, c, d}, {0, 0, -1});
}

inline Triangle make_triangle(Vec3 a, Vec3 b, Vec3 c) {
    Triangle triangle{{a, b, c}, {}, -1, {0, 0, -1}};
    triangle.normal = Vec3(glm::normalize(cross(DVec3(b) - DVec3(a), DVec3(c) - DVec3(a))));
    return triangle;
}

// Owns what a SceneView points to; ids are given in the order of adding.
struct World {
    std::vector<Sphere> spheres;
    std::vector<Quad> quads;
    mutable std::vector<SphereGroup> sphere_groups;
    mutable std::vector<QuadGroup> quad_groups;
    std::vector<Plane> planes;
    std::vector<Triangle> triangles;
    std::vector<TriangleRun> runs;
    int next_id = 0;

    void add(Sphere s) { s.tags = {next_id++, 0, -1}, spheres.push_back(s); }
    void add(Quad q) { q.tags = {next_id++, 0, -1}, quads.push_back(q); }
    void add(Plane p) { p.tags = {next_id++, 0, -1}, planes.push_back(p); }
    void add(Triangle t) { t.tags = {next_id++, 0, -1}, triangles.push_back(t); }

    // Boxes around every `size` triangles; size 0: one run without bounds, which is brute force.
    void make_runs(int size) {
        runs.clear();
        if (size == 0) {
            runs.push_back({{Vec3(-infinity), Vec3(infinity)}, 0, int(triangles.size())});
            return;
        }
        for (int first = 0; first < int(triangles.size()); first += size) {
            TriangleRun run{{}, first, std::min(size, int(triangles.size()) - first)};
            for (int i = first; i < first + run.count; ++i)
                for (const Vec3& v : triangles[i].v) run.bounds.include(v);
            runs.push_back(run);
        }
    }

    SceneView view() const {
        SceneView scene{};
        scene.spheres = {spheres.data(), int(spheres.size())};
        scene.quads = {quads.data(), int(quads.size())};
        sphere_groups = group_spheres(spheres);
        scene.sphere_groups = {sphere_groups.data(), int(sphere_groups.size())};
        quad_groups = group_quads(quads);
        scene.quad_groups = {quad_groups.data(), int(quad_groups.size())};
        scene.planes = {planes.data(), int(planes.size())};
        scene.triangles = {triangles.data(), int(triangles.size())};
        scene.runs = {runs.data(), int(runs.size())};
        return scene;
    }
};

// The six faces of a box with the given corners, outward; corner i lies high on axis k if bit k of
// i is set. Neighbours share the corners' bits.
inline void add_box(World& world, const Vec3 (&corner)[8]) {
    const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : faces)
        world.add(make_quad(corner[f[0]], corner[f[1]], corner[f[2]], corner[f[3]]));
}

// --- Meshes -----------------------------------------------------------------------------------

// A closed mesh with shared vertices.
struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> faces;
    std::vector<std::vector<int>> faces_at; // of each vertex

    Triangle triangle(int face) const {
        const auto& f = faces[face];
        return make_triangle(vertices[f[0]], vertices[f[1]], vertices[f[2]]);
    }
};

Mesh icosphere(int level, double radius, DVec3 center); // 20 * 4^level triangles

} // namespace raylab::test
