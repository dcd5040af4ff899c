// Tiers 1 and 3, and what is checked before all else.
#include "grader/judge/exact.h"
#include "grader/judge/json.h"
#include "grader/judge/same_paths.h"
#include "grader/judge/tests/simulated.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace raylab {
namespace {
using simulated::Noise;
using testing::HasSubstr;

Image some_image(int width = 64, int height = 32) {
    Image image = simulated::render(width, height, 5, 64, Noise::pixel);
    image.provenance.seed = 5;
    return image;
}

TEST(Soundness, EveryKindOfBadPixelIsCountedAndPlaced) {
    Image image = some_image();
    poison(image);
    EXPECT_EQ(check_soundness(image, 64, 32).unwritten, image.pixels());
    image = some_image();
    EXPECT_TRUE(check_soundness(image, 64, 32).verdict.passed);
    image.mean[64 + 3].y = std::numeric_limits<float>::infinity();
    image.mean[300].x = -1e-9f;
    image.mean[301].z = std::numeric_limits<float>::quiet_NaN();
    const Soundness s = check_soundness(image, 64, 32);
    EXPECT_FALSE(s.verdict.passed);
    EXPECT_EQ(s.not_finite, 2u);
    EXPECT_EQ(s.negative, 1u);
    EXPECT_EQ(s.unwritten, 0u);
    EXPECT_EQ(s.first_x, 3);
    EXPECT_EQ(s.first_y, 1);
    EXPECT_FALSE(check_soundness(image, 32, 64).verdict.passed);
    EXPECT_THAT(check_soundness(image, 32, 64).verdict.sentence,
                HasSubstr("32 x 64 were expected"));
}

TEST(SamePaths, RoundingPassesAndTheFirstRealDifferenceIsNamed) {
    const Image reference = some_image();
    Image image = reference;
    for (Vec3& v : image.mean) v *= 1.000004f; // a few roundings
    EXPECT_TRUE(judge_same_paths(image, reference).verdict.passed);

    // 64 x 32 x 64 spp = 131072 paths: one may part.
    image.mean[64 * 7 + 11].y *= 1.5f;
    SamePathsResult r = judge_same_paths(image, reference);
    EXPECT_TRUE(r.verdict.passed) << r.verdict.sentence;
    EXPECT_EQ(r.differing_pixels, 1u);
    image.mean[64 * 9].z *= 1.0001f;
    r = judge_same_paths(image, reference);
    EXPECT_FALSE(r.verdict.passed);
    EXPECT_EQ(r.first_x, 11);
    EXPECT_EQ(r.first_y, 7);
    EXPECT_THAT(r.verdict.sentence, HasSubstr("2 of 2048 pixels differ"));
    EXPECT_EQ(nlohmann::json(r)["first_difference"]["pixel"], (nlohmann::json{11, 7}));
}

TEST(SamePaths, NanFailsAndOtherSeedsAreNotCompared) {
    const Image reference = some_image();
    Image image = reference;
    image.mean.assign(image.pixels(), Vec3(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(judge_same_paths(image, reference).verdict.passed);
    image.provenance.seed = 6;
    EXPECT_THROW(judge_same_paths(image, reference), std::invalid_argument);
}

TEST(SamePaths, DarkImagesAreJudgedAsBrightOnes) {
    Image reference = some_image(), image = reference;
    for (Vec3& v : image.mean) v *= 1.0001f;
    for (const float scale : {1.0f, 0x1p-60f, 0x1p60f}) {
        Image a = image, b = reference;
        for (Vec3& v : a.mean) v *= scale;
        for (Vec3& v : b.mean) v *= scale;
        EXPECT_EQ(judge_same_paths(a, b).differing_pixels, a.pixels());
    }
}

TEST(SamePaths, TheFirstDifferingSampleAndSurfaceAreFound) {
    const SampleValue reference = [](int x, int y, int sample, int depth) {
        return Vec3(float(x + y + sample + depth));
    };
    const SampleValue wrong = [&](int x, int y, int sample, int depth) {
        return reference(x, y, sample, depth) + Vec3(sample == 5 && depth >= 3 ? 0.5f : 0.0f);
    };
    EXPECT_FALSE(find_first_difference(3, 4, 8, 6, reference, reference));
    const auto d = find_first_difference(3, 4, 8, 6, wrong, reference);
    ASSERT_TRUE(d);
    EXPECT_EQ(d->sample, 5);
    EXPECT_EQ(d->depth, 3);
    EXPECT_EQ(d->value, Vec3(15.5f));
}

// A disc's silhouette, as a whitted image has.
Image disc(float radius, float level) {
    Image image = some_image(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const float dx = float(x) - 31.5f, dy = float(y) - 31.5f;
            image.mean[std::size_t(y) * 64 + std::size_t(x)] =
                Vec3(dx * dx + dy * dy < radius * radius ? level : 0.1f);
        }
    return image;
}

TEST(Exact, AFewEdgePixelsPassAndMoreDoNot) {
    const Image reference = disc(20, 1);
    Image image = reference;
    EXPECT_TRUE(judge_exact(image, reference).verdict.passed);
    // The rim of row 32 goes over to the background: a neighbour's value. 64 x 64: 4 are allowed.
    for (int k = 0; k < 4; ++k) image.mean[std::size_t(30 + k) * 64 + 12] = Vec3(0.1f);
    ExactResult r = judge_exact(image, reference);
    EXPECT_EQ(r.edge, 4u);
    EXPECT_EQ(r.wrong, 0u);
    EXPECT_TRUE(r.verdict.passed) << r.verdict.sentence;
    image.mean[32 * 64 + 51] = Vec3(0.1f);
    EXPECT_FALSE(judge_exact(image, reference).verdict.passed);
}

TEST(Exact, OneValueThatNoNeighbourHoldsFails) {
    const Image reference = disc(20, 1);
    Image image = reference;
    image.mean[10].x = 0.1f + 0.9e-4f + 1e-4f; // within 1e-4 + 1e-3 x 0.1
    EXPECT_TRUE(judge_exact(image, reference).verdict.passed);
    image.mean[10].x = 0.1f + 3e-4f;
    const ExactResult r = judge_exact(image, reference);
    EXPECT_FALSE(r.verdict.passed);
    EXPECT_EQ(r.wrong, 1u);
    EXPECT_EQ(r.first_x, 10);
    image.mean[10].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(judge_exact(image, reference).verdict.passed);
}

TEST(Exact, IdsAreComparedForEquality) {
    std::vector<int> reference(4000, 7), ids;
    reference[0] = 8;
    ids = reference;
    EXPECT_TRUE(judge_exact(ids, reference, 80, 50).verdict.passed);
    ids[1] = 8; // a neighbour's
    EXPECT_TRUE(judge_exact(ids, reference, 80, 50).verdict.passed);
    ids[1] = 9;
    EXPECT_FALSE(judge_exact(ids, reference, 80, 50).verdict.passed);
    ids.pop_back();
    EXPECT_FALSE(judge_exact(ids, reference, 80, 50).verdict.passed);
}

TEST(Json, WhatIsNotFiniteIsNull) {
    SamePathsResult r;
    r.largest_relative_difference = std::numeric_limits<double>::infinity();
    EXPECT_THAT(nlohmann::json(r).dump(), HasSubstr("\"largest_relative_difference\":null"));
    EXPECT_TRUE(nlohmann::json(r)["first_difference"].is_null());
}

} // namespace
} // namespace raylab
