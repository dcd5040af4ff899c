// Brute force against an independent test in long double, and Embree against brute force.
#include "common/sampling/hash.h"
#include "grader/bench/rays/tests/fake_contestant.h"

#include <gtest/gtest.h>

namespace raylab::bench {
namespace {

using Long = glm::vec<3, long double>;

std::vector<Ray> rays_at(const RayMesh& mesh, int film) {
    RayMesh seen = mesh;
    set_film_size(seen.camera, film, film);
    std::vector<RaySet> sets =
        make_ray_sets(seen, *brute_force().build(mesh.triangles, 1).structure, 3);
    std::vector<Ray> rays = std::move(sets[0].rays);
    rays.insert(rays.end(), sets[3].rays.begin(), sets[3].rays.end());
    return rays;
}

// Moller and Trumbore's test, in the widest type there is.
long double meets(const Triangle& triangle, const Ray& ray) {
    const Long o(ray.o), d(ray.d), a(triangle.v[0]), e1 = Long(triangle.v[1]) - a,
                                                     e2 = Long(triangle.v[2]) - a;
    const Long p = glm::cross(d, e2), s = o - a, q = glm::cross(s, e1);
    const long double det = glm::dot(e1, p), u = glm::dot(s, p) / det, v = glm::dot(d, q) / det,
                      t = glm::dot(e2, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : HUGE_VALL;
}

TEST(BruteForce, FindsTheClosestHit) {
    const RayMesh mesh = small_mesh();
    const std::vector<Ray> rays = rays_at(mesh, 40);
    std::vector<RayAnswer> answers(rays.size());
    brute_force().build(mesh.triangles, 1).structure->closest(rays, answers);
    int hits = 0, differ = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        long double t = HUGE_VALL;
        for (const Triangle& triangle : mesh.triangles) t = std::min(t, meets(triangle, rays[i]));
        hits += answers[i].triangle >= 0;
        differ += std::isinf(t) != (answers[i].triangle < 0) ||
                  (std::isfinite(t) && std::fabs(double(t) - answers[i].t) > 1e-6 * double(t));
    }
    EXPECT_GT(hits, 50);
    EXPECT_EQ(differ, 0);
}

TEST(BruteForce, OfEqualHitsAnswersTheLowest) {
    const RayMesh mesh = small_mesh("identical");
    const Ray ray = {Vec3(0.2f, 0.2f, 1), Vec3(0, 0, -1)};
    RayAnswer answer;
    std::uint8_t blocked = 0;
    const auto built = brute_force().build(mesh.triangles, 1);
    built.structure->closest({&ray, 1}, {&answer, 1});
    built.structure->any({&ray, 1}, {&blocked, 1});
    EXPECT_EQ(answer.triangle, 0);
    EXPECT_EQ(answer.t, 1);
    EXPECT_TRUE(blocked);
}

TEST(BruteForce, ThreadsChangeNoAnswer) {
    const RayMesh mesh = small_mesh();
    const std::vector<Ray> rays = rays_at(mesh, 20);
    std::vector<RayAnswer> one(rays.size()), five(rays.size());
    brute_force().build(mesh.triangles, 1).structure->closest(rays, one);
    brute_force().build(mesh.triangles, 5).structure->closest(rays, five);
    for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(one[i].triangle, five[i].triangle);
}

// On every procedural mesh, at most the tolerated share of rays grazing an edge.
TEST(Embree, AgreesWithBruteForce) {
    std::vector<RayContestant> contestants = {brute_force()};
    try {
        for (const bool robust : {false, true}) contestants.push_back(embree(robust));
    } catch (const ContestantError& error) {
        GTEST_SKIP() << error.what();
    }
    RaceOptions options;
    options.baseline = "embree";
    options.builds = 1;
    options.least_seconds = 0;
    for (const char* kind : {"city", "fractal", "needles", "sphere_flake", "stadium", "terrain"}) {
        const RayRace result = race(small_mesh(kind, 64), contestants, options);
        EXPECT_EQ(result.truth, "brute");
        for (const RayRow& row : result.rows)
            for (const RayCell& cell : row.cells)
                EXPECT_TRUE(cell.agrees) << kind << ", " << row.name << ", " << name_of(cell.kind)
                                         << ": " << cell.differing << " differ";
        EXPECT_GT(result.rows[1].bytes_per_triangle, 20);
        EXPECT_LT(result.rows[1].bytes_per_triangle, 400);
        EXPECT_GT(result.rows[1].build_seconds.median, 0);
    }
}

} // namespace
} // namespace raylab::bench
