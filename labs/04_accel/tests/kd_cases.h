// What the tests of the KD-tree share: triangles, rays, and brute force to hold the walks to.
#pragma once

#include "common/geometry/triangle.h"
#include "common/sampling/hash.h"
#include "labs/04_accel/kd_build.h"
#include "labs/04_accel/kd_ropes.h"
#include "labs/04_accel/query.h"
#include "labs/04_accel/walk_kd_restart.h"
#include "labs/04_accel/walk_kd_ropes.h"
#include "labs/04_accel/walk_kd_stack.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

namespace raylab::lab04 {

// Random numbers, the same everywhere.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : seed_(seed) {}

    int below(int n) { return int(next() % std::uint32_t(n)); }
    float between(float a, float b) { return a + (b - a) * to_unit(next()); }
    Vec3 point(float a, float b) {
        const float x = between(a, b), y = between(a, b);
        return {x, y, between(a, b)};
    }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = point(-1, 1);
            if (dot(v, v) <= 1 && dot(v, v) > 1e-4f) return normalize(v);
        }
    }

  private:
    std::uint32_t next() { return pcg4d({seed_, ++count_, 4, 4}).x; }
    std::uint32_t seed_, count_ = 0;
};

// Triangles get ids in the order of adding, in steps: an id is not an index.
inline void add(std::vector<Triangle>& triangles, Vec3 a, Vec3 b, Vec3 c) {
    triangles.push_back({{a, b, c}, Vec3(0), -1, {7 + 3 * int(triangles.size()), 0, -1}});
}

// n triangles of this size anywhere in the cube [-1, 1]^3.
inline std::vector<Triangle> soup(int n, float size, std::uint32_t seed = 1) {
    Dice dice(seed);
    std::vector<Triangle> triangles;
    for (int i = 0; i < n; ++i) {
        const Vec3 p = dice.point(-1, 1), a = dice.point(-size, size), b = dice.point(-size, size);
        add(triangles, p, p + a, p + b);
    }
    return triangles;
}

// 2 n^2 triangles: hills over [-1, 1]^2, one surface without a gap.
inline std::vector<Triangle> hills(int n) {
    std::vector<Triangle> triangles;
    const auto at = [&](int i, int j) {
        const float x = 2.0f * i / n - 1, z = 2.0f * j / n - 1;
        return Vec3(x, 0.2f * std::sin(7 * x) * std::cos(5 * z), z);
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            add(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1));
            add(triangles, at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return triangles;
}

// Triangles with corners on the integers from 0 to 6, most of them in planes of the grid.
inline std::vector<Triangle> on_grid(int n) {
    Dice dice(43);
    std::vector<Triangle> triangles;
    while (int(triangles.size()) < n) {
        Vec3 v[3];
        for (Vec3& corner : v)
            corner = {float(dice.below(7)), float(dice.below(7)), float(dice.below(7))};
        const int axis = dice.below(4); // 3: any triangle
        if (axis < 3)
            for (Vec3& corner : v) corner[axis] = v[0][axis];
        const Vec3 normal = cross(v[1] - v[0], v[2] - v[0]);
        if (dot(normal, normal) > 0) add(triangles, v[0], v[1], v[2]);
    }
    return triangles;
}

// n x n houses on the integers, each a box of a height of its own, on one floor; 12 n^2 + 2
// triangles.
inline std::vector<Triangle> city(int n) {
    Dice dice(45);
    std::vector<Triangle> triangles;
    const auto quad = [&](Vec3 a, Vec3 u, Vec3 v) {
        add(triangles, a, a + u, a + u + v);
        add(triangles, a, a + u + v, a + v);
    };
    quad(Vec3(0), {0, 0, float(n)}, {float(n), 0, 0});
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec3 low(float(i), 0, float(j)), x(dice.below(2) ? 1 : 0.5f, 0, 0),
                y(0, float(1 + dice.below(3)), 0), z(0, 0, dice.below(2) ? 1 : 0.5f);
            quad(low, x, y), quad(low, y, z), quad(low, z, x);
            quad(low + z, x, y), quad(low + x, y, z), quad(low + y, z, x);
        }
    }
    return triangles;
}

// Rays from around and inside the cube [-1, 1]^3, half of them no longer than 1.
inline std::vector<Ray> any_rays(int n, std::uint32_t seed = 2) {
    Dice dice(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < n; ++i) {
        const Vec3 o = dice.point(-2, 2);
        rays.push_back({o, dice.direction(), i % 2 == 0 ? infinity : dice.between(0, 1)});
    }
    return rays;
}

// From above hills() down to them, at all angles.
inline std::vector<Ray> rays_down(int n) {
    Dice dice(6);
    std::vector<Ray> rays;
    for (int i = 0; i < n; ++i) {
        const Vec3 o = dice.point(-1, 1), target = dice.point(-1, 1);
        rays.push_back(
            {{o.x, 0.3f, o.z}, normalize(Vec3(target.x, 0, target.z) - Vec3(o.x, 0.3f, o.z))});
    }
    return rays;
}

// Along the axes, with 0 and -0 beside, and along diagonals, from points of the grid, half way
// between them, and anywhere.
inline std::vector<Ray> grid_rays(int n) {
    Dice dice(44);
    std::vector<Ray> rays;
    for (int i = 0; i < n; ++i) {
        Vec3 o, d;
        for (int axis = 0; axis < 3; ++axis) {
            const float places[] = {float(dice.below(9) - 1), dice.below(17) * 0.5f - 1,
                                    dice.between(-1, 7)};
            const float ways[] = {0.0f, -0.0f, 1.0f, -1.0f};
            o[axis] = places[dice.below(3)];
            d[axis] = ways[dice.below(4)];
        }
        if (dot(d, d) > 0) rays.push_back({o, normalize(d)});
    }
    return rays;
}

struct Answer {
    float t = infinity;
    int id = -1;
    bool any = false;
    WalkCounts closest; // of the walk for the closest hit
    bool endless = false;
};

inline Answer brute_force(const std::vector<Triangle>& triangles, const Ray& ray) {
    const ShearedRay sheared(ray);
    Answer best;
    for (const Triangle& triangle : triangles) {
        float t;
        if (!intersect(triangle, sheared, t)) continue;
        if (t < best.t || (t == best.t && triangle.tags.id < best.id))
            best.t = t, best.id = triangle.tags.id;
        best.any = true;
    }
    return best;
}

enum class KdWalk { stack, ropes, restart };
constexpr KdWalk kd_walks[] = {KdWalk::stack, KdWalk::ropes, KdWalk::restart};

template <class Query> void walk(KdWalk kind, const KdView& tree, Query& query) {
    switch (kind) {
    case KdWalk::stack:
        return walk_kd_stack(tree, query);
    case KdWalk::ropes:
        return walk_kd_ropes(tree, query);
    case KdWalk::restart:
        return walk_kd_restart(tree, query);
    }
}

// Cuts cost next to nothing, so cells are cut as long as it is allowed: for tests that want many
// planes.
inline KdBuildSettings deep() {
    return {.costs = {.step = 0.1, .empty_factor = 0.9}, .copies = 20};
}

// Triangles and a tree over them.
struct KdCase {
    explicit KdCase(std::vector<Triangle> t, const KdBuildSettings& settings = {})
        : triangles(std::move(t)) {
        tree = build_kd_tree(triangles, settings);
        lay_ropes(tree);
    }

    Answer answer(KdWalk kind, const Ray& ray) const {
        const Leaves leaves{{tree.blocks.data(), int(tree.blocks.size())},
                            {triangles.data(), int(triangles.size())}};
        ClosestHit closest(leaves, ray);
        walk(kind, tree.view(), closest);
        AnyHit any(leaves, ray);
        walk(kind, tree.view(), any);
        return {closest.hit().t, closest.hit().id, any.found(), closest.counts(),
                closest.endless() || any.endless()};
    }

    std::vector<Triangle> triangles;
    KdTree tree;
};

inline std::string name(KdWalk kind) {
    return kind == KdWalk::stack   ? "the walk with a stack"
           : kind == KdWalk::ropes ? "the walk along ropes"
                                   : "the walk that restarts";
}

// Empty if every ray finds with this walk what brute force finds, to the last bit of t; else the
// first ray that does not.
inline std::string difference(const KdCase& scene, KdWalk kind, const std::vector<Ray>& rays) {
    int wrong = 0;
    std::string first;
    for (const Ray& ray : rays) {
        const Answer truth = brute_force(scene.triangles, ray), found = scene.answer(kind, ray);
        if (!found.endless && found.any == truth.any && found.id == truth.id &&
            std::bit_cast<std::uint32_t>(found.t) == std::bit_cast<std::uint32_t>(truth.t))
            continue;
        if (wrong++ == 0)
            first = fmt::format(
                "{}: the ray from ({}, {}, {}) along ({}, {}, {}), t_max {}, {}; brute force finds "
                "triangle {} at t = {:a}, the walk {} at {:a}; any hit: {} and {}",
                name(kind), ray.o.x, ray.o.y, ray.o.z, ray.d.x, ray.d.y, ray.d.z, ray.t_max,
                found.endless ? "does not end" : "ends", truth.id, truth.t, found.id, found.t,
                truth.any, found.any);
        if (found.endless) break; // one takes long enough
    }
    return wrong == 0 ? "" : fmt::format("{} ({} of {} rays differ)", first, wrong, rays.size());
}

// How deep the deepest leaf lies; the root is at 0.
inline int depth(const KdTree& tree, int at = 0) {
    if (tree.nodes.empty() || tree.nodes[at].is_leaf()) return 0;
    return 1 + std::max(depth(tree, tree.nodes[at].below()), depth(tree, tree.nodes[at].above()));
}

} // namespace raylab::lab04
