// ONB: a frame is orthonormal around every normal, the poles and the seam z = +-0 included.
#include "common/math/frame.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace raylab {
namespace {

using RVec = glm::vec<3, long double>;

// The largest deviation of the three lengths from 1 and of the three dot products from 0.
double deviation(const Frame& f) {
    const RVec x(f.x), y(f.y), z(f.z);
    const long double parts[] = {dot(x, x) - 1, dot(y, y) - 1, dot(x, y), dot(y, z), dot(z, x)};
    double worst = 0;
    for (long double part : parts) worst = std::max(worst, double(fabsl(part)));
    return worst;
}

// Frisvad, 2012: one formula for all normals but the south pole, which is a special case.
Frame frisvad(Vec3 n) {
    if (n.z < -0.9999999f) return {Vec3(0, -1, 0), Vec3(-1, 0, 0), n};
    const float a = 1 / (1 + n.z), b = -n.x * n.y * a;
    return {Vec3(1 - n.x * n.x * a, b, -n.x), Vec3(b, 1 - n.y * n.y * a, -n.y), n};
}

// Normals from everywhere, half of them near the south pole or the equator; every sign of zero.
template <class Visit> void for_each_normal(int n, const Visit& visit) {
    std::uint64_t state = 1;
    const auto uniform = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return double(state >> 11) * 0x1p-53;
    };
    for (int i = 0; i < n; ++i) {
        const double x = 2 * uniform() - 1, y = 2 * uniform() - 1, z = 2 * uniform() - 1;
        const double small = std::pow(10, -7 * uniform());
        const DVec3 v = i % 4 == 0   ? DVec3(small * x, small * y, -1)
                        : i % 4 == 1 ? DVec3(x, y, 1e-7 * small * z)
                                     : DVec3(x, y, z);
        if (dot(v, v) > 1e-4) visit(Vec3(glm::normalize(v)));
    }
    for (float zero : {0.0f, -0.0f})
        for (float one : {1.0f, -1.0f})
            for (Vec3 v : {Vec3(one, zero, zero), Vec3(zero, one, zero), Vec3(zero, zero, one)})
                visit(v);
}

TEST(ONB, is_orthonormal_for_every_normal) {
    const int n = std::getenv("RAYLAB_LONG") ? 10'000'000 : 400'000;
    double ours = 0, naive = 0, lengths = 0;
    for_each_normal(n, [&](Vec3 v) {
        // A float normal is itself only unit to 1e-7, and the frame cannot be better than that.
        lengths = std::max(lengths, fabs(double(dot(RVec(v), RVec(v)) - 1)));
        ours = std::max(ours, deviation(Frame::around(v)));
        naive = std::max(naive, deviation(frisvad(v)));
    });
    std::printf(
        "  ONB           deviation from orthonormal %.3g <= 5e-7, Frisvad %.3g (normals: %.2g)\n",
        ours, naive, lengths);
    EXPECT_LE(ours, 5e-7);
    EXPECT_GT(naive, 5e-7);
}

TEST(ONB, is_right_handed_and_inverts) {
    double worst = 0;
    for_each_normal(10'000, [&](Vec3 v) {
        const Frame f = Frame::around(v);
        worst = std::max(worst, double(length(cross(f.x, f.y) - f.z)));
        const Vec3 w(0.36f, -0.48f, 0.8f);
        worst = std::max(worst, double(length(f.to_world(f.to_local(w)) - w)));
    });
    EXPECT_LE(worst, 1e-6);
}

} // namespace
} // namespace raylab
