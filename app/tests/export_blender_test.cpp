// What is written for Blender Cycles. `raylab bench` shows that Cycles draws the same picture from
// it. These tests show that the file says what the scene says, and that nothing is left out
// silently.
#include "app/export_blender.h"
#include "app/labs.h"
#include "common/load/load.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace raylab::app {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// The scene's data as Python would read them: a JSON text in a string that both languages write
// alike.
json exported(const Scene& scene) {
    const std::string text = blender_files(scene).at(0).bytes;
    const std::string begin = "SCENE = json.loads(";
    const std::size_t at = text.find(begin) + begin.size();
    return json::parse(json::parse(text.substr(at, text.find(")\n", at) - at)).get<std::string>());
}

std::string refusal(const std::string& scene) {
    try {
        blender_files(load_scene(find_scene(scene)));
    } catch (const UsageError& error) {
        return error.what();
    }
    return "written";
}

TEST(BlenderExport, SaysWhatTheSceneSays) {
    Scene scene = load_scene(find_scene("cornell_peers_spheres"));
    set_film_size(scene.camera, 512, 512);
    const json data = exported(scene);
    EXPECT_EQ(data["film"], json({512, 512}));
    EXPECT_NEAR(data["camera"]["vfov"], 2 * std::atan(0.012 / 0.035), 1e-6);
    EXPECT_EQ(data["bounces"], 6); // 8 surfaces: 7 scattering events, the first is no bounce
    EXPECT_EQ(data["materials"].size(), 6u);
    EXPECT_EQ(data["materials"]["glass"]["ior"], 1.5);
    EXPECT_EQ(data["materials"]["lamp"]["emission"], json({17.0, 12.0, 4.0}));
    ASSERT_EQ(data["spheres"].size(), 2u);
    EXPECT_EQ(data["spheres"][0]["material"], "mirror");
    std::size_t faces = 0;
    for (const json& mesh : data["meshes"]) faces += mesh["faces"].size();
    EXPECT_EQ(faces, 12u); // six quads
}

TEST(BlenderExport, IsPython) {
    if (std::system("python3 -c '' 2>/dev/null") != 0) GTEST_SKIP() << "no python3 is installed";
    const std::string file = testing::TempDir() + "raylab_blender_scene.py";
    std::ofstream(file) << blender_files(load_scene(find_scene("cornell"))).at(0).bytes;
    EXPECT_EQ(
        std::system(("python3 -c 'import ast; ast.parse(open(\"" + file + "\").read())'").c_str()),
        0);
}

TEST(BlenderExport, RefusesWithOneSentenceWhatItDoesNotKnow) {
    EXPECT_THAT(refusal("whitted"), HasSubstr("whole paths"));
    EXPECT_THAT(refusal("depth_of_field"), HasSubstr("lens"));
    EXPECT_THAT(refusal("soft_shadow"), HasSubstr("endless planes"));
    EXPECT_THAT(refusal("hdr_environment"), HasSubstr("Blender Cycles"));
    EXPECT_THAT(refusal("point_in_sphere"), HasSubstr("point lights"));
    EXPECT_EQ(refusal("cornell"), "written");
}

} // namespace
} // namespace raylab::app
