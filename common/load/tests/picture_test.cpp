// Pictures of textures and environment maps: the right values of every kind of file, and an error
// for each that is damaged. The files in fuzz/seeds/picture were written by other programs.
#include "common/load/picture.h"

#include "common/image/display.h"
#include "common/load/tests/scene_files.h"

#include <fstream>
#include <iterator>

namespace raylab {
namespace {

std::string seed(const std::string& name) {
    std::ifstream file(RAYLAB_FUZZ_SEEDS "/picture/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Picture picture_of(const std::string& name) { return decode_picture(seed(name), name); }

Vec3 srgb(double r, double g, double b, double white = 255) {
    return {linear_from_srgb(r / white), linear_from_srgb(g / white), linear_from_srgb(b / white)};
}

std::vector<Vec3> texels_of(const std::string& name) { return picture_of(name).texels; }

TEST(Png, IsReadInEveryKind) {
    const Vec3 black(0), white(1);
    EXPECT_EQ(texels_of("grey1.png"), (std::vector{white, black, white, black, //
                                                   black, white, white, black}));
    EXPECT_EQ(texels_of("palette4.png"),
              (std::vector{srgb(255, 0, 0), srgb(0, 128, 0), srgb(7, 8, 9)}));
    EXPECT_EQ(texels_of("rgba8.png"), (std::vector{srgb(10, 20, 30), srgb(40, 50, 60)}))
        << "transparency is left out";
    const Picture interlaced = picture_of("interlaced.png");
    ASSERT_EQ(interlaced.width, 5);
    ASSERT_EQ(interlaced.height, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            EXPECT_EQ(interlaced.texels[y * 5 + x], srgb(50 * x, 80 * y, 7)) << x << ' ' << y;
}

TEST(Png, OfSixteenBitsKeepsThemAndIsSrgbWhateverItsGammaChunkSays) {
    EXPECT_EQ(texels_of("grey16.png"),
              (std::vector{srgb(1000, 1000, 1000, 65535), Vec3(1)})); // 1000 / 256 is not whole
}

TEST(Png, MayCarryTextThatIsLargeForItsPicture) {
    EXPECT_EQ(picture_of("text.png").width, 1); // 91 bytes, one word of them text
}

TEST(Png, WithAnyBitFlippedIsAnErrorOrTheSamePicture) {
    int noticed = 0, flips = 0;
    for (const char* name :
         {"grey1.png", "grey16.png", "palette4.png", "rgba8.png", "interlaced.png", "square.png"}) {
        const std::string whole = seed(name);
        const Picture right = decode_picture(whole, name);
        for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
            std::string flipped = whole;
            flipped[bit / 8] = char(flipped[bit / 8] ^ 1 << bit % 8);
            ++flips;
            try {
                EXPECT_EQ(decode_picture(flipped, name).texels, right.texels) << name << ' ' << bit;
            } catch (const SceneError&) {
                ++noticed;
            }
        }
    }
    EXPECT_EQ(noticed, flips) << "each chunk has a check sum";
}

TEST(Hdr, IsReadWhereRunsRepeatPixels) {
    const Picture picture = picture_of("old_rle.hdr");
    ASSERT_EQ(picture.width, 300);
    ASSERT_EQ(picture.height, 2);
    for (int x = 0; x < 300; ++x) {
        EXPECT_EQ(picture.texels[x], Vec3(1, 0.5f, 0.25f)) << x;
        EXPECT_EQ(picture.texels[300 + x], x < 256 ? Vec3(0.5f) : Vec3(0.25f)) << x;
    }
    // A run with nothing before it, and one that goes on behind its row.
    EXPECT_THROW(decode_picture(hdr(4, 1, std::string("\1\1\1\4", 4)), "p"), SceneError);
    EXPECT_THROW(decode_picture(hdr(4, 1, std::string("\x80\x80\x80\x80\1\1\1\4", 8)), "p"),
                 SceneError);
}

TEST(Hdr, InXyzIsConvertedAndExposuresAreTakenOut) {
    // The last row first; X, Y, Z = 1, 1, 1 and 122/128, 1, 139/128, divided by EXPOSURE 2 x 4 and
    // by COLORCORR 1, 2, 4.
    const std::vector<Vec3> texels = texels_of("xyze.hdr");
    const auto expect_near = [](Vec3 c, double x, double y, double z) {
        // IEC 61966-2-1 rounds its matrix to four digits.
        EXPECT_NEAR(c.x, std::max(0.0, 3.2406 * x - 1.5372 * y - 0.4986 * z), 1e-4);
        EXPECT_NEAR(c.y, std::max(0.0, -0.9689 * x + 1.8758 * y + 0.0415 * z), 1e-4);
        EXPECT_NEAR(c.z, 0.0557 * x - 0.2040 * y + 1.0570 * z, 1e-4);
    };
    expect_near(texels.at(1), 1 / 8.0, 1 / 16.0, 1 / 32.0);
    expect_near(texels.at(0), 122 / 128.0 / 8, 1 / 16.0, 139 / 128.0 / 32);
    // The white D65 stays white, and a colour that sRGB cannot show is cut off at 0.
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n";
    const Picture two =
        decode_picture(head + std::string("\x7a\x80\x8b\x81\x00\x80\x00\x81", 8), "p");
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(two.texels[0][c], 1, 0.02);
    EXPECT_EQ(two.texels[1].x, 0);
    EXPECT_GT(two.texels[1].y, 1);
}

TEST(Hdr, IsReadInEachOfTheEightOrders) {
    // Pixels of 1, 2 ... 6, exponents 129 to 134, in the order of the file.
    std::string pixels;
    for (int i = 0; i < 6; ++i) pixels += std::string("\x80\x80\x80", 3) + char(129 + i);
    struct Case {
        const char* size;
        std::array<int, 6> rows; // powers of 2, three a row, the top row first
    };
    for (const auto& [size, rows] :
         {Case{"-Y 2 +X 3", {0, 1, 2, 3, 4, 5}}, Case{"-Y 2 -X 3", {2, 1, 0, 5, 4, 3}},
          Case{"+Y 2 +X 3", {3, 4, 5, 0, 1, 2}}, Case{"+Y 2 -X 3", {5, 4, 3, 2, 1, 0}},
          Case{"+X 3 -Y 2", {0, 2, 4, 1, 3, 5}}, Case{"-X 3 -Y 2", {4, 2, 0, 5, 3, 1}},
          Case{"+X 3 +Y 2", {1, 3, 5, 0, 2, 4}}, Case{"-X 3 +Y 2", {5, 3, 1, 4, 2, 0}}}) {
        // No FORMAT: RGBE, as Radiance takes it; other programs' names; lines that end in CR LF.
        const Picture picture = decode_picture(
            std::string("#?RGBE\r\nmade by hand\r\n\r\n") + size + "\n" + pixels, "p");
        ASSERT_EQ(picture.width, 3) << size;
        ASSERT_EQ(picture.height, 2) << size;
        for (int i = 0; i < 6; ++i)
            EXPECT_EQ(picture.texels[i], Vec3(float(1 << rows[i]))) << size << ' ' << i;
    }
}

TEST(Hdr, SaysWhatOfItsHeaderIsWrong) {
    const auto message = [](const std::string& lines, const std::string& size) {
        return error_of([&] {
            decode_picture("#?RADIANCE\n" + lines + "\n" + size + "\n\x80\x80\x80\x80", "p");
        });
    };
    const std::string advice = "; write or copy it again";
    EXPECT_EQ(message("FORMAT=32-bit_rle_spec\n", "-Y 1 +X 1"),
              "p: cannot read the image: its header says FORMAT=32-bit_rle_spec, and raylab reads "
              "32-bit_rle_rgbe and 32-bit_rle_xyze" +
                  advice);
    EXPECT_EQ(
        message("EXPOSURE=0\n", "-Y 1 +X 1"),
        "p: cannot read the image: its header says EXPOSURE=0, which is not a number above 0" +
            advice);
    EXPECT_EQ(
        message("EXPOSURE=nan\n", "-Y 1 +X 1"),
        "p: cannot read the image: its header says EXPOSURE=nan, which is not a number above 0" +
            advice);
    EXPECT_EQ(message("", "-Y 1 +Y 1"),
              "p: cannot read the image: its size should read as -Y HEIGHT +X WIDTH, and reads "
              "'-Y 1 +Y 1'" +
                  advice);
}

TEST(Picture, ThatEndsTooEarlyIsAnError) {
    const std::string whole = png(3, 3, std::string(27, '\x33'));
    EXPECT_EQ(decode_picture(whole, "p").texels.size(), 9u);
    for (std::size_t size = 0; size < whole.size() - 4; ++size) // the last check sum covers nothing
        EXPECT_THROW(decode_picture(whole.substr(0, size), "p"), SceneError) << size;
    const std::string map = hdr(4, 2, std::string(32, '\x80'));
    EXPECT_EQ(decode_picture(map, "p").texels.size(), 8u);
    for (std::size_t size = 0; size < map.size(); ++size)
        EXPECT_THROW(decode_picture(map.substr(0, size), "p"), SceneError) << size;
    // Run lengths that never come: the library alone would wait for them for ever.
    EXPECT_THROW(decode_picture(hdr(8, 1, std::string("\2\2\0\x08\x88", 5)), "p"), SceneError);
}

TEST(Picture, OfNoSizeOrTooLargeOneIsAnError) {
    EXPECT_THROW(decode_picture(hdr(8, 0, ""), "p"), SceneError);
    EXPECT_THROW(decode_picture(hdr(0, 8, ""), "p"), SceneError);
    EXPECT_THROW(decode_picture(hdr(16385, 1, ""), "p"), SceneError);
    EXPECT_THROW(decode_picture(hdr(8192, 4096, "short"), "p"), SceneError);
    EXPECT_NE(error_of([] { decode_picture(hdr(16384, 16384, ""), "p"); }).find("16384 x 16384"),
              std::string::npos);
}

TEST(Png, ChunksThatReachBeyondTheFileAreRefusedBeforeTheyAreAllocated) {
    std::string huge = png(2, 2, std::string(12, '\x33'));
    huge.replace(huge.find("IDAT") - 4, 4, std::string("\x3f\xff\xff\xff", 4)); // a gigabyte
    EXPECT_THROW(decode_picture(huge, "p"), SceneError);
}

TEST(Jpeg, IsReadAsLinearRgb) {
    const Picture picture = picture_of("ramp.jpg");
    ASSERT_EQ(picture.width, 8);
    ASSERT_EQ(picture.height, 8);
    const int first_row[] = {2, 4, 7, 10, 14, 18, 20, 22}; // as another decoder has it
    for (std::size_t x = 0; x < 8; ++x)
        EXPECT_NEAR(picture.texels[x].y, linear_from_srgb(first_row[x] / 255.0), 1e-3) << x;
    EXPECT_GT(picture.texels.back().y, picture.texels.front().y) << "the top row is first";
}

TEST(Jpeg, OfWhichAByteLacksIsAnError) {
    const std::string whole = seed("ramp.jpg");
    for (std::size_t size = 3; size + 2 < whole.size(); ++size)
        EXPECT_THROW(decode_picture(whole.substr(0, size), "p"), SceneError) << size;
}

TEST(Jpeg, OfPrintingInksIsReadWithWhiteWhereThereAreNone) {
    // Left: all cyan. Right: magenta 128, yellow 255, black 51 of 255, which Pillow shows as
    // (204, 102, 0). Adobe's programs write what ink leaves; a file that does not name them, ink.
    const std::string adobe = seed("cmyk.jpg");
    const std::size_t segment = adobe.find("Adobe") - 4;
    const std::string plain = adobe.substr(0, segment) + adobe.substr(segment + 16);
    const Vec3 left = srgb(0, 255, 255), right = srgb(204, 102, 0);
    const Vec3 inverted_left = srgb(0, 0, 0), inverted_right = srgb(0, 26, 51);
    for (const bool is_adobe : {true, false}) {
        const Picture picture = decode_picture(is_adobe ? adobe : plain, "p");
        const Vec3 found_left = picture.texels[3 * 16 + 2],
                   found_right = picture.texels[3 * 16 + 12];
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(found_left[c], (is_adobe ? left : inverted_left)[c], 0.01) << is_adobe;
            EXPECT_NEAR(found_right[c], (is_adobe ? right : inverted_right)[c], 0.01) << is_adobe;
        }
    }
    // The last byte of the segment: 2 says YCCK. Pillow reads it as (143, 0, 2).
    std::string ycck = adobe;
    ycck[segment + 15] = 2;
    const Vec3 found = decode_picture(ycck, "p").texels[3 * 16 + 12];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], srgb(143, 0, 2)[c], 0.01);
}

TEST(Jpeg, OfOtherKindsSaysWhatItIs) {
    std::string twelve = seed("ramp.jpg"), lossless = twelve;
    const std::size_t frame = twelve.find("\xFF\xC0");
    ASSERT_NE(frame, twelve.npos);
    twelve[frame + 4] = 12;
    lossless[frame + 1] = '\xC3';
    EXPECT_EQ(error_of([&] { decode_picture(twelve, "p"); }),
              "p: cannot read the image: it is a JPEG of 12 bits a channel, and raylab reads lossy "
              "ones of 8: save it as such a JPEG, or as a PNG, which may have 16; write or copy it "
              "again");
    EXPECT_EQ(error_of([&] {
                  decode_picture(lossless, "p");
              }).find("p: cannot read the image: it is a lossless JPEG of 8 bits a channel"),
              0u);
}

} // namespace
} // namespace raylab
