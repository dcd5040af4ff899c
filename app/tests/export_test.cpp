// What is written for Mitsuba. tools/cross_check shows that Mitsuba draws the same picture from it.
// These tests show that the files say what the scene says, and that nothing is left out silently.
#include "app/export_mitsuba.h"
#include "app/export_ply.h"
#include "app/labs.h"
#include "common/geometry/make_quad.h"
#include "common/image/formats.h"
#include "common/load/load.h"

#include <gmock/gmock.h>

namespace raylab::app {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string scene_with(const std::string& material, const std::string& lights = "") {
    return R"({"version": 1, "title": "t", "reason": "r",
        "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40},
        "film": {"width": 8, "height": 8},
        "render": {"integrator": "path", "max_depth": 4, "spp": 1, "seed": 1},
        "materials": {"a & b": )" +
           material + R"(},
        "shapes": [{"kind": "quad", "vertices": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]],
                    "material": "a & b"}])" +
           lights + "}";
}

std::string bytes_of(const std::vector<ExportedFile>& files, const std::string& name) {
    for (const ExportedFile& file : files)
        if (file.name == name) return file.bytes;
    ADD_FAILURE() << "no file " << name;
    return {};
}

std::string refusal_of(const std::string& material) {
    try {
        mitsuba_files(parse_scene(scene_with(material), "test.json"));
    } catch (const UsageError& error) {
        return error.what();
    }
    return "written";
}

TEST(MitsubaExport, RefusesByNameWhatMitsubaDoesNotHave) {
    EXPECT_THAT(
        refusal_of(
            R"({"kind": "phong", "reflectance": [0, 0, 0], "specular": [1, 1, 1], "exponent": 9})"),
        HasSubstr("'a & b' is Phong's"));
    EXPECT_THAT(refusal_of(R"({"kind": "glass", "ior": 1.5, "fresnel": "schlick"})"),
                HasSubstr("Schlick"));
    EXPECT_EQ(refusal_of(R"({"kind": "glass", "ior": 1.5})"), "written");
    EXPECT_THROW(mitsuba_files(load_scene(find_scene("whitted"))), UsageError);
}

TEST(MitsubaExport, EscapesNamesAndLeavesOutUnusedMaterials) {
    const auto files = mitsuba_files(
        parse_scene(scene_with(R"({"kind": "diffuse", "reflectance": [0.25, 0.5, 0.75]},
                                  "unused": {"kind": "phong", "reflectance": [0, 0, 0],
                                             "specular": [1, 1, 1], "exponent": 9})"),
                    "test.json"));
    const std::string xml = bytes_of(files, "scene.xml");
    EXPECT_THAT(xml, HasSubstr(R"(id="0_a &amp; b")"));
    EXPECT_THAT(xml, HasSubstr(R"(<rgb name="reflectance" value="0.25 0.5 0.75"/>)"));
    EXPECT_THAT(xml, Not(HasSubstr("unused")));
}

// The lamp's second face: the same square seen from behind, just behind it.
TEST(MitsubaExport, LightsShineFromBothSides) {
    PlyMesh front;
    front.add(make_quad({Vec3(0, 0, 3), Vec3(2, 0, 3), Vec3(2, 2, 3), Vec3(0, 2, 3)}, {}));
    const PlyMesh back = front.back(0.25f);
    for (const auto& [i, j, k] : back.faces) {
        const Vec3 a = back.positions[i], b = back.positions[j], c = back.positions[k];
        EXPECT_LT(cross(b - a, c - a).z, 0);
        EXPECT_EQ(a.z, 2.75f);
        EXPECT_EQ(b.z, 2.75f);
        EXPECT_EQ(c.z, 2.75f);
    }
    const auto files = mitsuba_files(parse_scene(
        scene_with(R"({"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [1, 2, 3]})"),
        "test.json"));
    EXPECT_EQ(files.size(), 3u); // the scene and two faces
}

TEST(MitsubaExport, FloatsSurviveAsText) {
    PlyMesh mesh;
    mesh.add(Triangle{
        {Vec3(0.1f, 1.0f / 3, 1e-30f), Vec3(16777217, 2, 3), Vec3(-0.7f, 5, 6e30f)}, {}, -1, {}});
    const std::string text = encode_ply(mesh);
    const std::size_t body = text.find("end_header\n") + 11;
    Vec3 p;
    ASSERT_EQ(std::sscanf(text.c_str() + body, "%f %f %f", &p.x, &p.y, &p.z), 3);
    EXPECT_EQ(p, mesh.positions[0]);
}

TEST(MitsubaExport, TheSkyIsTurned) {
    Scene scene =
        parse_scene(scene_with(R"({"kind": "diffuse", "reflectance": [0, 0, 0]})"), "test.json");
    scene.environment_light = 0;
    scene.environment_width = scene.environment_height = 1;
    scene.environment_map = {Vec3(1)};
    const auto matrix = [&](float turn) {
        scene.environment_turn = turn;
        const std::string text = bytes_of(mitsuba_files(scene), "scene.xml");
        const std::size_t at = text.find("value=\"", text.find("sky.exr\"/>"));
        return text.substr(at, text.find('"', at + 7) + 1 - at);
    };
    // Columns: where Mitsuba's x, y and z go. Its sky's u = 1/4, at x, lies towards our +z, or
    // where phi is 90 degrees less the turn.
    EXPECT_EQ(matrix(0), "value=\"0 0 -1 0 0 1 0 0 1 0 0 0 0 0 0 1\"");
    float m[16];
    ASSERT_EQ(std::sscanf(matrix(0.125f).c_str(), "value=\"%f %f %f %f %f %f %f %f %f %f %f", &m[0],
                          &m[1], &m[2], &m[3], &m[4], &m[5], &m[6], &m[7], &m[8], &m[9], &m[10]),
              11);
    const double half = std::sqrt(0.5);
    EXPECT_NEAR(m[0], half, 1e-6);
    EXPECT_NEAR(m[8], half, 1e-6);
    EXPECT_NEAR(m[2], -half, 1e-6);
    EXPECT_NEAR(m[10], half, 1e-6);
}

// The mean of the interpolated sky over one texel of the map. It is the texel's own radiance,
// except on the ramps to the neighbours above and below: each neighbour adds a quarter of a ramp
// and takes as much.
TEST(MitsubaExport, TheFineSkyKeepsEachTexelsLight) {
    Scene scene =
        parse_scene(scene_with(R"({"kind": "diffuse", "reflectance": [0, 0, 0]})"), "test.json");
    const int w = 4, h = 3;
    scene.environment_light = 0;
    scene.environment_radiance = Vec3(2);
    scene.environment_width = w;
    scene.environment_height = h;
    for (int i = 0; i < w * h; ++i) scene.environment_map.push_back(Vec3(i * i, 1, 100 - i));
    const Image sky = formats::decode_exr(bytes_of(mitsuba_files(scene), "sky.exr"));
    const int nx = sky.width / w, ny = (sky.height - 1) / h;
    ASSERT_EQ(sky.width, nx * w);
    ASSERT_EQ(sky.height, ny * h + 1); // Mitsuba's first and last row lie on the poles
    const auto texel = [&](int row, int column) {
        return 2.0 * DVec3(scene.environment_map[std::clamp(row, 0, h - 1) * w + column]);
    };
    for (int row = 0; row < h; ++row)
        for (int column = 0; column < w; ++column) {
            DVec3 sum(0); // trapezoids over rows; the columns' samples lie inside the texel
            for (int y = 0; y <= ny; ++y)
                for (int x = 0; x < nx; ++x)
                    sum += DVec3(sky.at(column * nx + x, row * ny + y)) * (y % ny == 0 ? 0.5 : 1.0);
            const DVec3 own = texel(row, column);
            const DVec3 gained = texel(row - 1, column) + texel(row + 1, column) - 2.0 * own;
            const DVec3 expected = own + gained / (4.0 * ny);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(sum[c] / (nx * ny), expected[c], 1e-6 * (1 + expected[c]));
        }
}

} // namespace
} // namespace raylab::app
