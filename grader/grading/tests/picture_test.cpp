// Standing controls: pictures that must fail whatever the scene is, and pictures that must pass.
#include "grader/grading/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace raylab::grading {
namespace {

constexpr int side = 96;

// A scene with edges and shades; `other`: another one.
Vec3 radiance(int x, int y, bool other) {
    const bool box = other ? (x / 24 + y / 24) % 2 == 0 : x > 30 && x < 60 && y > 40;
    return box ? Vec3(.8f, .3f, .1f) : Vec3(.2f + .004f * float(x), .3f, .1f + .003f * float(y));
}

// A render: each pixel is the mean of spp samples of relative variance 1/4.
Drawn render(std::uint32_t seed, int spp, bool other = false) {
    Drawn drawn;
    drawn.image.width = drawn.image.height = side;
    drawn.image.provenance.spp = spp;
    std::mt19937 random(seed);
    std::gamma_distribution<float> noise(4.0f * float(spp), 1 / (4.0f * float(spp)));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            drawn.image.mean.push_back(radiance(x, y, other) * noise(random));
    return drawn;
}

using Change = std::function<void(Image&)>;

PictureResult judge(const Change& change) {
    return judge_picture(
        [&](std::uint32_t seed, int spp) {
            Drawn drawn = render(seed, spp);
            change(drawn.image);
            return drawn;
        },
        [](std::uint32_t seed, int spp) { return render(seed, spp); });
}

Vec3 mean_colour(const Image& image) {
    Vec3 sum(0);
    for (const Vec3& pixel : image.mean) sum += pixel;
    return sum / float(image.pixels());
}

void blur(Image& image) {
    const Image sharp = image;
    for (int y = 1; y + 1 < side; ++y)
        for (int x = 1; x + 1 < side; ++x) {
            Vec3 sum(0);
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) sum += sharp.at(x + dx, y + dy);
            image.mean[std::size_t(y) * side + std::size_t(x)] = sum / 9.0f;
        }
}

TEST(Picture, StandingControlsFail) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const struct {
        const char* name;
        Change change;
        MarkVerdict verdict;
    } controls[] = {
        {"black", [](Image& i) { std::fill(i.mean.begin(), i.mean.end(), Vec3(0)); },
         MarkVerdict::suspicious},
        {"the mean colour",
         [](Image& i) { std::fill(i.mean.begin(), i.mean.end(), mean_colour(i)); },
         MarkVerdict::wrong_image},
        {"blurred", blur, MarkVerdict::suspicious},
        {"another scene's", [](Image& i) { i = render(7, 64, true).image; },
         MarkVerdict::suspicious},
        {"upside down", [](Image& i) { std::reverse(i.mean.begin(), i.mean.end()); },
         MarkVerdict::wrong_image},
        {"red and blue swapped",
         [](Image& i) {
             for (Vec3& pixel : i.mean) std::swap(pixel.x, pixel.z);
         },
         MarkVerdict::wrong_image},
        {"2 % too bright",
         [](Image& i) {
             for (Vec3& pixel : i.mean) pixel *= 1.02f;
         },
         MarkVerdict::wrong_image},
        {"one pixel is not a number", [nan](Image& i) { i.mean[5000].y = nan; },
         MarkVerdict::non_finite},
        {"one pixel is negative", [](Image& i) { i.mean[5000].y = -1; }, MarkVerdict::wrong_image},
        {"too small",
         [](Image& i) {
             i.height -= 1;
             i.mean.resize(i.pixels());
         },
         MarkVerdict::wrong_size},
        {"the same for each seed", [](Image& i) { i = render(7, 64).image; },
         MarkVerdict::suspicious},
    };
    for (const auto& control : controls) {
        const PictureResult result = judge(control.change);
        EXPECT_EQ(result.verdict, control.verdict) << control.name << ": " << result.sentence;
    }
}

TEST(Picture, TheSolutionsOwnPathsPassAtOnce) {
    const PictureResult result = judge([](Image&) {});
    EXPECT_EQ(result.verdict, MarkVerdict::pass) << result.sentence;
    EXPECT_TRUE(result.same_paths);
}

TEST(Picture, OtherRandomNumbersPass) {
    const PictureResult result =
        judge_picture([](std::uint32_t seed, int spp) { return render(seed ^ 0x5bd1e995u, spp); },
                      [](std::uint32_t seed, int spp) { return render(seed, spp); });
    EXPECT_EQ(result.verdict, MarkVerdict::pass) << result.sentence;
    EXPECT_FALSE(result.same_paths);
}

TEST(Picture, WhatGaveNoImageSaysWhy) {
    const PictureResult result = judge_picture(
        [](std::uint32_t, int) {
            Drawn drawn;
            drawn.trouble = MarkVerdict::time_limit;
            drawn.sentence = "late";
            return drawn;
        },
        [](std::uint32_t seed, int spp) { return render(seed, spp); });
    EXPECT_EQ(result.verdict, MarkVerdict::time_limit);
    EXPECT_EQ(result.sentence, "late");
}

} // namespace
} // namespace raylab::grading
