// Polygons cut into triangles: each covered once, whatever its shape.
#include "common/load/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace raylab {
namespace {

using Corners = std::vector<DVec3>;

DVec3 area_vector(DVec3 a, DVec3 b, DVec3 c) { return 0.5 * cross(b - a, c - a); }

// The lengths of the triangles' area vectors sum to the polygon's area if and only if no triangle
// is turned over, for then all vectors point the same way.
void expect_covered_once(const Corners& corners, const char* what) {
    DVec3 whole(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        whole += area_vector(corners[0], corners[i], corners[i + 1]);
    double sum = 0;
    const auto triangles = cut_polygon(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2) << what;
    for (const auto& [a, b, c] : triangles) {
        const DVec3 part = area_vector(corners[a], corners[b], corners[c]);
        EXPECT_GE(dot(part, whole), 0) << what << ": a triangle is turned over";
        sum += std::sqrt(dot(part, part));
    }
    EXPECT_NEAR(sum / std::sqrt(dot(whole, whole)), 1, 1e-12) << what;
}

void expect_covered_once_anyhow(const Corners& flat, const char* what) {
    Corners turned, lying, backwards(flat.rbegin(), flat.rend());
    for (const DVec3& p : flat) {
        turned.push_back({p.z + p.x, p.y, 3 * p.x - p.y});
        lying.push_back({p.y, p.z, p.x});
    }
    expect_covered_once(flat, what);
    expect_covered_once(turned, what);
    expect_covered_once(lying, what);
    expect_covered_once(backwards, what);
    for (std::size_t first = 1; first < std::min<std::size_t>(flat.size(), 8); ++first) {
        Corners rotated = flat; // which corner is listed first does not matter
        std::rotate(rotated.begin(), rotated.begin() + std::ptrdiff_t(first), rotated.end());
        expect_covered_once(rotated, what);
    }
}

Corners around(int count, double (*radius)(int)) {
    Corners corners;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        corners.push_back({radius(i) * std::cos(angle), radius(i) * std::sin(angle), 0});
    }
    return corners;
}

TEST(Polygon, WithNotchesIsCoveredOnce) {
    expect_covered_once_anyhow({{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}, "dart");
    expect_covered_once_anyhow(
        {{0, -1, 0}, {6, -1, 0}, {3, 0, 0}, {2, 10, 0}, {1, 0, 0}, {0, 10, 0}},
        "two spikes"); // tinyobjloader 2.0's triangles cover it twice
    expect_covered_once_anyhow(
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},
        "a square with corners on its edges");
    for (const int count : {5, 8, 100, 257, 4000}) {
        expect_covered_once(around(count, [](int) { return 1.0; }), "circle");
        if (count % 2 == 0)
            expect_covered_once(around(count, [](int i) { return i % 2 ? 1 : 0.3; }), "star");
    }
    Corners comb{{0, -1, 0}, {1000, -1, 0}}, spiral;
    for (int i = 997; i >= 0; --i) comb.push_back({double(i), i % 2 ? 0.0 : 10.0, 0});
    for (int i = 0; i < 1000; ++i) { // out along one side, back along the other
        const double t = (i < 500 ? i : 999 - i) / 25.0, r = t + (i < 500 ? 1.2 : 1);
        spiral.push_back({r * std::cos(t), r * std::sin(t), 0});
    }
    expect_covered_once(comb, "comb");
    expect_covered_once(spiral, "spiral");
}

TEST(Polygon, WithAHoleIsCoveredOnce) {
    // A square with a square hole, reached over a bridge whose two corners are listed twice.
    expect_covered_once_anyhow({{0, 0, 0},
                                {9, 0, 0},
                                {9, 9, 0},
                                {0, 9, 0},
                                {0, 0, 0},
                                {3, 3, 0},
                                {3, 6, 0},
                                {6, 6, 0},
                                {6, 3, 0},
                                {3, 3, 0}},
                               "hole");
}

TEST(Polygon, ThatIsNoneGivesTrianglesAllTheSame) {
    EXPECT_EQ(cut_polygon(Corners(7, DVec3(1))).size(), 5u) << "all corners in one place";
    EXPECT_EQ(cut_polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size(), 3u);
    EXPECT_EQ(cut_polygon(around(5, [](int i) { return i % 2 ? -1.0 : 1.0; })).size(), 3u);
}

TEST(Polygon, ThatCrossesItselfEverywhereTakesNoMinutes) {
    // Cubic time would be hours.
    EXPECT_EQ(cut_polygon(around(16384, [](int i) { return i * 7919 % 16384 - 8192.0; })).size(),
              16382u);
}

TEST(Polygon, OfFourCornersIsCutAlongTheShorterDiagonal) {
    using Triangles = std::vector<std::array<int, 3>>;
    EXPECT_EQ(cut_polygon({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}}),
              (Triangles{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(cut_polygon({{0, 0, 0}, {1, -1, 0}, {1, 0, 0}, {1, 1, 0}}),
              (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

} // namespace
} // namespace raylab
