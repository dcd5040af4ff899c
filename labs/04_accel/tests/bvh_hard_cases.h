// What the tests of hard cases for boxes share: every walk through every tree is held to brute
// force.
#pragma once

#include "labs/04_accel/lbvh/build.h"
#include "labs/04_accel/tests/bvh_cases.h"

#include <gtest/gtest.h>

namespace raylab::lab04 {

// Without a wide tree: that one is made of the other binary trees.
inline BvhCase along_the_curve(const std::vector<Triangle>& triangles) {
    const DeviceArray<Triangle> on_device(triangles);
    return {triangles, to_host(build_lbvh({on_device.data(), int(triangles.size())}))};
}

inline void expect_truth(const BvhCase& scene, const std::vector<Ray>& rays,
                         const std::vector<Answer>& truths, const std::string& what) {
    for (const BoxWalk kind : box_walks) {
        if (is_wide(kind) && scene.wide.nodes.empty()) continue;
        EXPECT_EQ(difference(truths, name(kind), rays,
                             [&](const Ray& ray) { return scene.answer(kind, ray); }),
                  "")
            << what;
    }
}

inline void expect_equal_to_brute_force(const BvhCase& scene, const std::vector<Ray>& rays,
                                        const std::string& what) {
    const std::vector<Answer> truths = brute_force(scene.triangles, rays);
    expect_truth(scene, rays, truths, what);
    expect_truth(along_the_curve(scene.triangles), rays, truths, what + ", along the Morton curve");
}

inline void expect_equal_to_brute_force(const std::vector<Triangle>& triangles,
                                        const std::vector<Ray>& rays, const std::string& what) {
    expect_equal_to_brute_force(BvhCase(triangles), rays, what);
}

// Two trees, every walk: the same hit, the same t.
inline void expect_equal_answers(const BvhCase& a, const BvhCase& b, const std::vector<Ray>& rays) {
    for (const Ray& ray : rays)
        for (const BoxWalk kind : box_walks)
            ASSERT_TRUE(same(a.answer(kind, ray), b.answer(kind, ray))) << name(kind);
}

inline const std::vector<std::pair<const char*, std::vector<Triangle>>>& meshes() {
    static const std::vector<std::pair<const char*, std::vector<Triangle>>> all = {
        {"soup", soup(1000, 0.3f)}, {"dust", soup(4000, 0.02f)}, {"hills", hills(24)},
        {"city", city(8)},          {"grid", on_grid(400)},
    };
    return all;
}

} // namespace raylab::lab04
