// Image files: bits survive, damage is named, and nothing crashes or leaves half a file.
#include "common/image/image_file.h"

#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"
#include "common/image/display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

namespace raylab {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

class ImageFile : public testing::Test {
  protected:
    std::string in(const std::string& name) const { return (folder / name).string(); }

    TemporaryFolder temporary;
    const fs::path folder = temporary.path();
};

// Every kind of float there is: random bits, so also NaN with payload, infinities, subnormals, -0.
Image any_bits(int width, int height, bool with_error) {
    std::mt19937 random(7);
    const auto any = [&] {
        const auto bits = static_cast<std::uint32_t>(random());
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    };
    Image image;
    image.width = width;
    image.height = height;
    image.mean.resize(image.pixels());
    if (with_error) image.error.resize(image.pixels());
    for (auto* pixels : {&image.mean, &image.error})
        for (Vec3& v : *pixels)
            for (int c = 0; c < 3; ++c) v[c] = any();
    image.mean[0] = Vec3(std::numeric_limits<float>::quiet_NaN(), -0.0f,
                         std::numeric_limits<float>::infinity());
    image.mean[1] = Vec3(std::numeric_limits<float>::denorm_min(), 1e38f, -1);
    image.provenance = {"cornell", "0123456789abcdef", "path", "02_iterative", 4294967295u, 64, 8};
    return image;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0);
}

// Without write_file's fsync: thousands of damaged files need not survive a power cut.
void put(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string error_of(const std::string& path) {
    try {
        read_image(path);
    } catch (const ImageError& e) {
        return e.what();
    }
    return "no error";
}

TEST_F(ImageFile, ExrKeepsEveryBitAndTheProvenance) {
    for (const bool with_error : {false, true}) {
        const Image image = any_bits(37, 21, with_error);
        write_image(image, in("a.exr"));
        const Image back = read_image(in("a.exr"));
        EXPECT_EQ(back.width, 37);
        EXPECT_EQ(back.height, 21);
        EXPECT_TRUE(same_bits(image.mean, back.mean));
        EXPECT_TRUE(same_bits(image.error, back.error));
        EXPECT_EQ(back.provenance.scene, "cornell");
        EXPECT_EQ(back.provenance.scene_hash, "0123456789abcdef");
        EXPECT_EQ(back.provenance.integrator, "path");
        EXPECT_EQ(back.provenance.renderer, "02_iterative");
        EXPECT_EQ(back.provenance.seed, 4294967295u);
        EXPECT_EQ(back.provenance.spp, 64);
        EXPECT_EQ(back.provenance.max_depth, 8);
    }
}

// Other programs find the variance, if float can hold it. No bit is lost when the file is read
// again.
TEST_F(ImageFile, ExrHoldsTheVarianceOrWhereFloatCannotTheError) {
    std::mt19937 random(3);
    for (const int exponent : {-149, -110, -60, 0, 60, 110, 127}) {
        Image image = any_bits(16, 16, true);
        for (Vec3& v : image.error)
            for (int c = 0; c < 3; ++c)
                v[c] = std::ldexp(0.5f + float(random()) * 0x1p-33f, exponent + int(random() % 2));
        image.error[0] = Vec3(0, 0, std::numeric_limits<float>::infinity());
        write_image(image, in("a.exr"));
        EXPECT_TRUE(same_bits(image.error, read_image(in("a.exr")).error)) << exponent;
        const bool has_variance = read_file(in("a.exr")).find("variance.R") != std::string::npos;
        EXPECT_EQ(has_variance, std::abs(exponent) < 61) << exponent;
    }
}

TEST_F(ImageFile, PfmKeepsEveryBitOfTheMean) {
    const Image image = any_bits(5, 9, true);
    write_image(image, in("a.PFM"));
    const Image back = read_image(in("a.PFM"));
    EXPECT_TRUE(same_bits(image.mean, back.mean));
    EXPECT_TRUE(back.error.empty());
}

TEST_F(ImageFile, PfmHasTheBottomRowFirstAndReadsBothEndians) {
    Image image = any_bits(1, 2, false);
    image.mean = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
    write_image(image, in("a.pfm"));
    const std::string bytes = read_file(in("a.pfm"));
    const std::string header = "PF\n1 2\n-1.0\n";
    ASSERT_EQ(bytes.substr(0, header.size()), header);
    float first;
    std::memcpy(&first, bytes.data() + header.size(), sizeof first);
    EXPECT_EQ(first, 4);

    write_file(in("big.pfm"), std::string("Pf\n1 1\n1.0\n") + std::string("\x3f\x80\0\0", 4));
    EXPECT_EQ(read_image(in("big.pfm")).mean[0], Vec3(1));
}

TEST_F(ImageFile, HdrKeepsAboutEightBits) {
    Image image = any_bits(16, 8, false);
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const float v = std::exp2(static_cast<float>(i % 40) - 20);
        image.mean[i] = Vec3(v, 0.9f * v, 0.6f * v);
    }
    image.mean[3] = Vec3(NAN, -1, INFINITY);
    write_image(image, in("a.hdr"));
    const Image back = read_image(in("a.hdr"));
    EXPECT_EQ(back.mean[3], Vec3(0));
    image.mean[3] = Vec3(0);
    for (std::size_t i = 0; i < image.pixels(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(back.mean[i][c], image.mean[i][c], max_component(image.mean[i]) / 128);
}

TEST_F(ImageFile, PngIsExposedAndInSrgb) {
    Image image = any_bits(4, 1, false);
    image.mean = {Vec3(0.25f, 0.5f, 1), Vec3(0, -3, 99), Vec3(NAN), Vec3(0.001f)};
    write_image(image, in("a.png"), -1);
    const Image back = read_image(in("a.png"));
    // One 8-bit step of the sRGB curve is at most 1/255 x 2.3 in linear light.
    EXPECT_NEAR(back.mean[0].x, 0.125f, 0.005f);
    EXPECT_NEAR(back.mean[0].y, 0.25f, 0.005f);
    EXPECT_NEAR(back.mean[0].z, 0.5f, 0.005f);
    EXPECT_EQ(back.mean[1], Vec3(0, 0, 1));
    EXPECT_EQ(back.mean[2], Vec3(1, 0, 1)) << "what is no number should be magenta";
    EXPECT_NEAR(back.mean[3].x, 0.0005f, 0.0002f);
}

TEST(Display, TheSrgbCurveMeetsItsPublishedPointsAndItsInverse) {
    EXPECT_NEAR(srgb_from_linear(0.214041f), 0.5f, 1e-5f);
    EXPECT_EQ(display_rgb8(Vec3(0.2158605f), 0)[0], 128);
    EXPECT_EQ(display_rgb8(Vec3(1), 0)[1], 255);
    for (int i = 0; i <= 255; ++i)
        EXPECT_EQ(display_rgb8(Vec3(linear_from_srgb(static_cast<float>(i) / 255)), 0)[2], i);
}

TEST_F(ImageFile, EveryTruncationIsAnErrorThatNamesTheFile) {
    Image image = any_bits(33, 40, true);
    for (const char* ending : {"exr", "pfm", "hdr", "png"}) {
        const std::string path = in(std::string("a.") + ending);
        write_image(image, path);
        const std::string whole = read_file(path);
        for (int part = 0; part < 64; ++part) {
            put(path, whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 64));
            const std::string error = error_of(path);
            EXPECT_THAT(error, HasSubstr("cannot read '" + path)) << ending << " " << part << "/64";
        }
    }
}

// Damage may go unseen (PFM has no checksum), but must end in an image or an ImageError.
TEST_F(ImageFile, DamagedBytesNeverCrash) {
    std::mt19937 random(3);
    const Image image = any_bits(33, 40, true);
    int refused = 0;
    for (const char* ending : {"exr", "pfm", "hdr", "png"}) {
        const std::string path = in(std::string("a.") + ending);
        write_image(image, path);
        const std::string whole = read_file(path);
        for (int round = 0; round < 300; ++round) {
            std::string bytes = whole;
            const std::size_t reach =
                round % 2 ? std::min<std::size_t>(600, whole.size()) : whole.size();
            for (int k = 0; k < 1 + round % 5; ++k)
                bytes[random() % reach] = static_cast<char>(random());
            put(path, bytes);
            refused += error_of(path) != "no error";
        }
    }
    EXPECT_GT(refused, 100) << "hardly any damage was noticed: does the test still damage?";
}

TEST_F(ImageFile, AHeaderThatAsksForAllMemoryIsRefused) {
    const auto refused = [&](const std::string& path, const std::string& bytes, const char* why) {
        write_file(path, bytes);
        EXPECT_THAT(error_of(path), HasSubstr(why));
    };
    refused(in("a.pfm"), "PF\n100000 100000\n-1.0\n", "at most");
    refused(in("a.pfm"), "PF\n8192 8192\n-1.0\nabc", "far more than");
    refused(in("a.pfm"), "PF\n0 5\n-1.0\n", "0 x 5");
    refused(in("a.pfm"), "PF\n-3 5\n-1.0\n", "-3 x 5");
    refused(in("a.pfm"), "PF\n9999999999999999999 5\n-1.0\n", "not a number");
    refused(in("a.pfm"), "GIF89a", "PFM header");
    refused(in("a.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20000 +X 3000\nabc", "far more");

    // The data window (xMax, yMax) of a real EXR file, changed in place.
    write_image(any_bits(8, 8, false), in("a.exr"));
    std::string bytes = read_file(in("a.exr"));
    const std::size_t window = bytes.find("dataWindow") + std::strlen("dataWindow") + 1 + 6 + 4;
    for (const std::int32_t huge : {99999, 0x7ffffffe, 16383}) {
        std::memcpy(&bytes[window + 8], &huge, 4);
        std::memcpy(&bytes[window + 12], &huge, 4);
        write_file(in("a.exr"), bytes);
        EXPECT_THAT(error_of(in("a.exr")), HasSubstr("cannot read")) << huge;
    }
}

TEST_F(ImageFile, WhatIsNoImageIsSaidPlainly) {
    write_file(in("a.exr"), "");
    EXPECT_THAT(error_of(in("a.exr")), HasSubstr("0 bytes"));
    EXPECT_THAT(error_of(in("missing.exr")), HasSubstr("no such file"));
    EXPECT_THAT(error_of(in("a.gif")), HasSubstr(".exr, .pfm, .hdr or .png"));
    write_file(in("text.exr"), "this is a text, not an image");
    EXPECT_THAT(error_of(in("text.exr")), HasSubstr("as an exr image"));
}

TEST_F(ImageFile, EndingsMayBeInCapitals) {
    const Image image = any_bits(4, 4, false);
    write_image(image, in("a.ExR"));
    EXPECT_EQ(read_image(in("a.ExR")).width, 4);
}

TEST_F(ImageFile, AWriteThatFailsLeavesNoFile) {
    const Image image = any_bits(4, 4, false);
    EXPECT_THROW(write_image(image, in("no/folder/a.exr")), FileError);
    EXPECT_THROW(write_image(image, in("a.gif")), ImageError);
    Image broken = image;
    broken.mean.pop_back();
    EXPECT_THROW(write_image(broken, in("a.exr")), ImageError);
    EXPECT_TRUE(fs::is_empty(folder));
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    fs::create_symlink("/dev/full", folder / "full.exr");
    try {
        write_image(image, in("full.exr"));
        FAIL() << "writing to a full disk succeeded";
    } catch (const FileError& e) {
        EXPECT_THAT(e.what(), HasSubstr("disk is full"));
        EXPECT_EQ(e.code, ExitCode::tool_failed);
    }
}

} // namespace
} // namespace raylab
