// What the tests of walks share: triangles, rays, and brute force to hold every walk to.
#pragma once

#include "common/geometry/triangle.h"
#include "common/sampling/hash.h"
#include "labs/04_accel/leaf/query.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace raylab::lab04 {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

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

inline float power_of_two(Dice& dice, int from, int to) {
    return std::ldexp(1.0f, from + dice.below(to - from + 1));
}

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

// One triangle, n times.
inline std::vector<Triangle> identical(int n) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < n; ++i) add(triangles, {0, 0, 0}, {1, 0, 1}, {0, 1, 0.5f});
    return triangles;
}

// Across a corner of space, each twice as large as the last: from 2^-60 to 2^59.
inline std::vector<Triangle> nested() {
    std::vector<Triangle> triangles;
    for (int k = -60; k < 60; ++k) {
        const float s = std::ldexp(1.0f, k);
        add(triangles, {s, 0, 0}, {0, s, 0}, {0, 0, s});
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

// At corners and along edges of the triangles, from anywhere, and from other corners.
inline std::vector<Ray> rays_at_edges(const std::vector<Triangle>& triangles, int n) {
    Dice dice(3);
    std::vector<Ray> rays;
    while (int(rays.size()) < n) {
        const Triangle& triangle = triangles[dice.below(int(triangles.size()))];
        const int corner = dice.below(3);
        const Vec3 a = triangle.v[corner], b = triangle.v[(corner + 1) % 3];
        const float along[] = {0, 0.5f, dice.between(0, 1)};
        const Vec3 target = a + along[dice.below(3)] * (b - a);
        const Vec3 o = dice.below(3) > 0
                           ? dice.point(-2, 2)
                           : triangles[dice.below(int(triangles.size()))].v[dice.below(3)];
        if (dot(target - o, target - o) > 0) rays.push_back({o, normalize(target - o)});
    }
    return rays;
}

struct Answer {
    float t = infinity;
    int id = -1;
    bool any = false;
    WalkCounts closest; // of the walk for the closest hit,
    WalkCounts shadow;  // and of that for any hit
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

inline std::vector<Answer> brute_force(const std::vector<Triangle>& triangles,
                                       const std::vector<Ray>& rays) {
    std::vector<Answer> answers;
    for (const Ray& ray : rays) answers.push_back(brute_force(triangles, ray));
    return answers;
}

// Two crowds of eight triangles, one behind the other, and a ray through both.
struct TwoCrowds {
    static constexpr float near = 0, far = 10; // where they lie along the ray

    // axis: of the ray; down: it goes down that axis.
    TwoCrowds(int axis, bool down) : ray(Vec3(0), Vec3(0)) {
        ray.o[axis] = down ? 12.15f : -2.0f; // 2 before the first triangle
        ray.d[axis] = down ? -1.0f : 1.0f;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < 16; ++i) {
            Vec3 corner[3];
            for (int k = 0; k < 3; ++k) {
                corner[k][axis] = (i < 8 ? near : far) + 0.01f * float(i);
                corner[k][u] = k == 0 ? -1.0f : 1.0f;
                corner[k][v] = k == 2 ? 1.5f : -1.0f;
            }
            add(triangles, corner[0], corner[1], corner[2]);
        }
        first = down ? 8 : 0; // of the crowd that the ray comes to first
    }

    std::vector<Triangle> triangles;
    Ray ray;
    int first;
};

// A query that notes what a walk visits.
class Notes : public Query {
  public:
    static constexpr bool reach_shrinks = true;

    Notes(const std::vector<TrianglePack>& packs, const Ray& ray) : Query(ray), packs_(packs) {}

    int first(int axis) const { return slab.negative[axis]; }
    float reach() const { return visits.empty() ? infinity : reach_behind_first; }
    void ask_for(int) const {}
    int packs() const { return int(packs_.size()); }
    bool visit(int pack) {
        visits.push_back(packs_[pack].index[0]);
        return end_at_first;
    }

    // The lowest index in a pack tells which crowd it is of.
    int visits_of_crowd(int first_index) const {
        int n = 0;
        for (const int index : visits) n += index / 8 == first_index / 8;
        return n;
    }

    std::vector<int> visits;             // the first triangle of each pack, in order
    float reach_behind_first = infinity; // reach() once a pack was visited
    bool end_at_first = false;           // what a visit says

  private:
    const std::vector<TrianglePack>& packs_;
};

// What a walk does among two crowds that it must do: a sentence on what is wrong, or "".
// walk(crowds, notes) is the walk over a structure of their triangles.
struct WalkHabits {
    std::string walk; // its name
    bool near_first = true;
    std::string when_endless = "it must get on from each leaf and never come to it again";

    template <class Case, class Walk>
    std::string wrong(const std::vector<TrianglePack>& packs, const TwoCrowds& crowds,
                      const Case& scene, const Walk& go) const {
        const int first = crowds.first, second = 8 - first;
        Notes all(packs, crowds.ray);
        go(scene, all);
        if (all.endless())
            return fmt::format("{} does not end between two leaves; the likely cause: {}", walk,
                               when_endless);
        if (all.visits.empty() || all.counts().nodes == 0)
            return fmt::format("{} visits {} packs and calls step() {} times on the way through "
                               "two leaves; the likely cause: step() at each node, visit() at each "
                               "leaf",
                               walk, all.visits.size(), all.counts().nodes);
        if (all.visits_of_crowd(first) == 0 || all.visits_of_crowd(second) == 0)
            return fmt::format(
                "a ray crosses two leaves, and {} visits only {}; the likely cause: {}", walk,
                all.visits_of_crowd(first) == 0 ? "the far one" : "the near one",
                all.visits.size() == 1
                    ? "it ends at the first leaf, though the visit does not say so"
                    : "a leaf on the way is passed over");
        if (near_first && all.visits.front() / 8 != first / 8)
            return fmt::format("{} visits the far leaf before the near one; the likely cause: the "
                               "far child is visited first",
                               walk);
        Notes behind(packs, crowds.ray);
        behind.reach_behind_first = 20;
        go(scene, behind);
        if (behind.visits_of_crowd(second) == 0 || behind.visits_of_crowd(first) == 0)
            return fmt::format("with a hit behind both leaves {} visits only one of them; the "
                               "likely cause: the walk ends at the first hit, which may lie behind "
                               "the leaf that it was found in",
                               walk);
        Notes shorter(packs, crowds.ray);
        shorter.reach_behind_first = 2.001f;
        go(scene, shorter);
        if (shorter.visits.front() / 8 == first / 8 && shorter.visits_of_crowd(second) > 0)
            return fmt::format("{} visits a leaf 12 ahead although a hit is 2 ahead; the likely "
                               "cause: what lies behind the hit must be left out, by query.reach()",
                               walk);
        Notes ended(packs, crowds.ray);
        ended.end_at_first = true;
        go(scene, ended);
        if (ended.visits.size() != 1)
            return fmt::format("{} goes on to {} more packs when a visit has said that it may end; "
                               "the likely cause: a visit that returns true ends the walk",
                               walk, ended.visits.size() - 1);
        return "";
    }
};

// What a walk finds: once for the closest hit, once for any. walk: a function of a query.
template <class Walk>
Answer answer_of(const std::vector<TrianglePack>& packs, const std::vector<Triangle>& triangles,
                 const Ray& ray, const Walk& walk) {
    const Leaves leaves{{packs.data(), int(packs.size())},
                        {triangles.data(), int(triangles.size())}};
    ClosestHit closest(leaves, ray);
    walk(closest);
    AnyHit any(leaves, ray);
    walk(any);
    return {closest.hit().t,  closest.hit().id, any.found(),
            closest.counts(), any.counts(),     closest.endless() || any.endless()};
}

// To the last bit of t.
inline bool same(const Answer& a, const Answer& b) {
    return a.any == b.any && a.id == b.id &&
           std::bit_cast<std::uint32_t>(a.t) == std::bit_cast<std::uint32_t>(b.t);
}

// Empty if every ray finds with this walk the truth, to the last bit of t; else the first ray that
// does not. truth: brute force's; answer: the walk's, a function of the ray.
template <class Find>
std::string difference(const std::vector<Answer>& truths, const std::string& walk,
                       const std::vector<Ray>& rays, const Find& answer) {
    int wrong = 0;
    std::string first;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& ray = rays[i];
        const Answer &truth = truths[i], found = answer(ray);
        if (!found.endless && same(found, truth)) continue;
        if (wrong++ == 0)
            first = fmt::format(
                "{}: the ray from ({}, {}, {}) along ({}, {}, {}), t_max {}, {}; brute force finds "
                "triangle {} at t = {:a}, the walk {} at {:a}; any hit: {} and {}",
                walk, ray.o.x, ray.o.y, ray.o.z, ray.d.x, ray.d.y, ray.d.z, ray.t_max,
                found.endless ? "does not end" : "ends", truth.id, truth.t, found.id, found.t,
                truth.any, found.any);
        if (found.endless) break; // one takes long enough
    }
    return wrong == 0 ? "" : fmt::format("{} ({} of {} rays differ)", first, wrong, rays.size());
}

} // namespace raylab::lab04
