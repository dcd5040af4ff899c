// DRIFT: a direction stays a unit vector through a thousand mirrors and panes.
#include "common/math/vec.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>

namespace raylab {
namespace {

double length_error(Vec3 d) {
    const glm::vec<3, long double> v(d);
    return double(fabsl(sqrtl(dot(v, v)) - 1));
}

// Reflection and refraction as vectors (PBR4e 9.3), without normalising the result.
Vec3 reflect(Vec3 d, Vec3 n) { return d - 2 * dot(d, n) * n; }

Vec3 refract(Vec3 d, Vec3 n,
             float eta) { // eta: index before over index behind, no total reflection
    const float cos_i = -dot(d, n);
    const float cos_t = sqrtf(1 - eta * eta * (1 - cos_i * cos_i));
    return eta * d + (eta * cos_i - cos_t) * n;
}

TEST(DRIFT, normalising_keeps_directions_unit_for_a_thousand_events) {
    std::uint64_t state = 7;
    const auto uniform = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return float(state >> 40) * 0x1p-24f;
    };
    double drift2 = 0, renormalised = 0;
    const int paths = 100;
    for (int path = 0; path < paths; ++path) {
        Vec3 d = normalize(Vec3(1, 2, 3)), u = d;
        bool inside = false;
        for (int event = 0; event < 1000; ++event) {
            Vec3 n = Vec3(uniform(), uniform(), uniform()) * 2.0f - 1.0f;
            if (length_squared(n) < 0.01f) continue;
            n = normalize(n);
            const bool goes_through = event % 2 && (!inside || fabsf(dot(d, n)) > 0.8f);
            const float eta = inside ? 1.5f : 1 / 1.5f;
            const Vec3 facing_d = dot(d, n) < 0 ? n : -n, facing_u = dot(u, n) < 0 ? n : -n;
            d = goes_through ? refract(d, facing_d, eta) : reflect(d, n);
            u = normalize(goes_through && fabsf(dot(u, n)) > 0.75f ? refract(u, facing_u, eta)
                                                                   : reflect(u, n));
            inside = inside != goes_through;
            renormalised = std::max(renormalised, length_error(u));
        }
        drift2 += length_error(d) * length_error(d) / paths;
    }
    const double drift = sqrt(drift2); // of a path, root mean square
    std::printf(
        "  DRIFT         |d| - 1 after 1000 events %.3g <= 2e-7; not renormalised %.3g <= 1e-5\n",
        renormalised, drift);
    EXPECT_LE(renormalised, 2e-7);
    EXPECT_LE(drift, 1e-5);
    EXPECT_GT(drift, 2e-7) << "without normalising the tolerance would be met as well";
}

} // namespace
} // namespace raylab
