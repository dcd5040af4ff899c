// Rays of each kind: how many, from where, which way, how far.
#include "grader/bench/rays/ray_sets.h"

#include "grader/bench/rays/tests/fake_contestant.h"

#include <gtest/gtest.h>

namespace raylab::bench {
namespace {

// A room [0, 1]^3 of six quads, seen from inside.
RayMesh room(int film) {
    RayMesh mesh;
    const auto triangle = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
        mesh.triangles.push_back({{a, b, c}, normal, -1, {int(mesh.triangles.size()), 0, -1}});
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const float at : {0.0f, 1.0f}) {
            Vec3 corner[4];
            for (int i = 0; i < 4; ++i) {
                corner[i][axis] = at;
                corner[i][(axis + 1) % 3] = float(i & 1);
                corner[i][(axis + 2) % 3] = float(i >> 1);
            }
            Vec3 normal(0);
            normal[axis] = 1; // on one of the two sides outward: rays must turn it over
            triangle(corner[0], corner[1], corner[3], normal);
            triangle(corner[0], corner[3], corner[2], normal);
        }
    mesh.camera = pinhole(DVec3(0.5, 0.4, 0.9), DVec3(0.5, 0.5, 0));
    set_film_size(mesh.camera, film, film);
    return mesh;
}

std::vector<RaySet> sets_of(const RayMesh& mesh, std::uint32_t seed = 1) {
    return make_ray_sets(mesh, *brute_force().build(mesh.triangles, 1).structure, seed);
}

TEST(RaySets, InAClosedRoomEveryRayLeadsToTheNext) {
    const RayMesh mesh = room(40);
    for (const RaySet& set : sets_of(mesh)) {
        EXPECT_EQ(set.rays.size(), 1600u) << name_of(set.kind);
        for (const Ray& ray : set.rays) {
            ASSERT_NEAR(length(ray.d), 1, 1e-6f);
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_GT(ray.o[axis], 0) << name_of(set.kind);
                ASSERT_LT(ray.o[axis], 1);
            }
        }
    }
}

TEST(RaySets, ARayThatMissesLeadsToNone) {
    RayMesh mesh = small_mesh();
    mesh.camera.forward = -mesh.camera.forward;
    const std::vector<RaySet> sets = sets_of(mesh);
    EXPECT_EQ(sets[0].rays.size(), 256u);
    for (std::size_t kind = 1; kind < 5; ++kind) EXPECT_TRUE(sets[kind].rays.empty());
}

TEST(RaySets, ShadowRaysEndAtTheLampAndAoRaysAtAFifthOfTheDiagonal) {
    const std::vector<RaySet> sets = sets_of(room(40));
    for (const Ray& ray : sets[int(RayKind::shadow)].rays) {
        const Vec3 lamp = ray(ray.t_max / 0.999f);
        ASSERT_NEAR(lamp.y, 0.99f, 1e-5f);
        for (const float side : {lamp.x, lamp.z}) {
            ASSERT_GT(side, 0.2499f);
            ASSERT_LT(side, 0.7501f);
        }
    }
    for (const Ray& ray : sets[int(RayKind::ao)].rays)
        ASSERT_NEAR(ray.t_max, 0.2f * std::sqrt(3.0f), 1e-6f);
    for (const Ray& ray : sets[int(RayKind::diffuse1)].rays) ASSERT_EQ(ray.t_max, infinity);
}

// Of a cosine-distributed direction the mean cosine is 2/3, its standard deviation sqrt(1/18). Six
// standard errors: a false alarm in 5 * 10^8 runs, and the seed is fixed.
TEST(RaySets, BouncesAreCosineDistributedAroundTheirSurface) {
    const std::vector<RaySet> sets = sets_of(room(100));
    for (const RayKind kind : {RayKind::ao, RayKind::diffuse1, RayKind::diffuse2}) {
        double sum = 0;
        const std::vector<Ray>& rays = sets[int(kind)].rays;
        for (const Ray& ray : rays) {
            // The wall it left is the nearest; inward is away from it.
            int axis = 0;
            const auto gap = [&](int a) { return std::min(ray.o[a], 1 - ray.o[a]); };
            for (int a = 1; a < 3; ++a)
                if (gap(a) < gap(axis)) axis = a;
            const float cosine = ray.o[axis] < 0.5f ? ray.d[axis] : -ray.d[axis];
            if (gap(axis) < 1e-3f) sum += cosine - 2 / 3.0;
        }
        EXPECT_LT(std::fabs(sum), 6 * std::sqrt(double(rays.size()) / 18)) << name_of(kind);
    }
}

TEST(RaySets, FollowFromTheSeed) {
    const RayMesh mesh = room(20);
    const auto first = [&](std::uint32_t seed) {
        std::vector<float> x;
        for (const RaySet& set : sets_of(mesh, seed)) x.push_back(set.rays[7].d.x);
        return x;
    };
    EXPECT_EQ(first(1), first(1));
    const std::vector<float> a = first(1), b = first(2);
    for (std::size_t kind = 0; kind < 5; ++kind) EXPECT_NE(a[kind], b[kind]);
}

} // namespace
} // namespace raylab::bench
