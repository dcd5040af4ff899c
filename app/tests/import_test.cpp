// Mesh files as scenes: what comes out loads, shows the same, and is written to be edited.
#include "app/import_scene.h"

#include "app/labs.h"
#include "common/cli/tests/temporary_folder.h"
#include "common/load/load.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace raylab::app {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

class Import : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& bytes) { folder_.write(name, bytes); }
    ImportedScene import(const std::string& name) {
        const auto read = [&](const std::string& file) {
            std::ifstream in(folder_ / file, std::ios::binary);
            if (!in) throw SceneError("there is no file " + file);
            return std::string(std::istreambuf_iterator<char>(in), {});
        };
        return import_scene(parse_mesh(read(name), name, read, MeshLook::own), name, "title");
    }
    Scene load(const std::string& text) { return parse_scene(text, folder_ / "s.json"); }

    TemporaryFolder folder_;
};

const std::string square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

// Buffer: three corners of a triangle in x, y, z: (0,0,0), (1,0,0), (0,1,0).
const std::string triangle_buffer =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

std::string gltf(const std::string& nodes, const std::string& more) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
"nodes": [)" +
           nodes + R"(],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": ")" +
           triangle_buffer + R"("}], )" + more + "}";
}

TEST_F(Import, WritesCameraLightsAndMaterialsOfAGltfFile) {
    // The camera turned by 90 degrees about y looks along -x.
    write(
        "m.gltf",
        gltf(
            R"({"mesh": 0, "translation": [0, 0, -5]},
{"camera": 0, "name": "Eye", "translation": [3, 1, 2], "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]},
{"translation": [0, 4, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}})",
            R"("cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "aspectRatio": 1.5, "znear": 0.1}}],
"materials": [{"name": "Red", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1], "metallicFactor": 0, "roughnessFactor": 1}}],
"extensionsUsed": ["KHR_lights_punctual"],
"extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 20, "color": [1, 0.5, 0.25]}]}})"));
    const ImportedScene imported = import("m.gltf");
    const Scene scene = load(imported.text);
    EXPECT_EQ(scene.camera.position, Vec3(3, 1, 2));
    EXPECT_NEAR(scene.camera.forward.x, -1, 1e-6);
    EXPECT_NEAR(scene.camera.up.y, 1, 1e-6);
    EXPECT_NEAR(scene.camera.half_height, std::tan(0.25), 1e-6);
    EXPECT_EQ(scene.camera.width, 360);
    EXPECT_EQ(scene.camera.height, 240);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].position, Vec3(0, 4, 0));
    EXPECT_EQ(scene.lights[0].intensity, Vec3(20, 10, 5));
    ASSERT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.triangles[0].v[1], Vec3(1, 0, -5));
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    EXPECT_THAT(imported.text, HasSubstr("\n        \"Red\": {\"kind\": \""));
    EXPECT_THAT(imported.text,
                HasSubstr("\"materials\": {\"Red\": \"Red\"}, \"lights\": false}\n"));
    // The scene's material is the file's, bit for bit, and takes its place when it is edited.
    Scene own = load(
        R"({"version": 1, "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40},
"film": {"width": 4, "height": 4}, "shapes": [{"kind": "mesh", "file": "m.gltf", "lights": true}]})");
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(std::memcmp(&scene.materials[0], &own.materials[0], sizeof(Material)), 0);
    std::string edited = imported.text;
    const std::size_t begin = edited.find("\"Red\": {") + 7;
    edited.replace(begin, edited.find('}', begin) + 1 - begin,
                   R"({"kind": "mirror", "reflectance": [1, 1, 1]})");
    const Scene mirror = load(edited);
    EXPECT_EQ(mirror.materials[mirror.triangles[0].tags.material].kind, MaterialKind::mirror);
}

TEST_F(Import, GivesACameraAndALightWhereAFileHasNone) {
    write("m.obj", square + "f 1 2 3 4\n");
    const ImportedScene imported = import("m.obj");
    const Scene scene = load(imported.text);
    EXPECT_EQ(scene.environment_radiance, Vec3(1));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("no camera")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("even white sky")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("grey stands in")));
    // All corners lie inside the frame, and the whole fills more than a quarter of its height.
    float most = 0;
    for (const Triangle& triangle : scene.triangles)
        for (const Vec3 p : triangle.v) {
            const Vec3 d = p - scene.camera.position;
            const float depth = dot(d, scene.camera.forward);
            ASSERT_GT(depth, 0);
            EXPECT_LT(std::fabs(dot(d, scene.camera.right)), depth * scene.camera.half_width);
            most = std::max(most, std::fabs(dot(d, scene.camera.up)) /
                                      (depth * scene.camera.half_height));
        }
    EXPECT_LT(most, 1);
    EXPECT_GT(most, 0.25);
}

TEST_F(Import, ReadsTheMaterialsOfAnObjFile) {
    write("lib one.mtl", "newmtl Wall paint\r\nKd 0.5 0.25 0.125\r\nillum 1\r\n"
                         "newmtl Glass\nKd 0 0 0\nNi 1.25\nTf 0.5 0.75 1\nillum 7\nd 0.1\n"
                         "newmtl Lamp\nKd 0 0 0\nKe 4 3 2\n"
                         "newmtl Mirror\nKd 0 0 0\nKs 0.75 0.5 0.25\nillum 3\n"
                         "newmtl Shiny\nKd 0.75 0.5 0\nKs 0.75 0.25 0.25\nNs 50\nillum 2\n"
                         "newmtl Image\nKd 0 0 0\nmap_Kd textures\\t.hdr\n");
    fs::create_directory(folder_ / "textures");
    write("textures/t.hdr", "#?RADIANCE\n\n-Y 1 +X 1\n\x80\x40\x20\x80");
    write("m.obj", "mtllib lib one.mtl\n" + square +
                       "f 1 2 3\nusemtl Wall paint\nf 1 2 3 4\nusemtl Glass\nf 1 2 3\n"
                       "usemtl Lamp\nf 1 2 3\nusemtl Mirror\nf 1 2 3\nusemtl Shiny\nf 1 2 3\n"
                       "usemtl Image\nf 1/1 2/2 3/3\nf 1 3 4\nusemtl Lost\nf 1 2 3\n");
    const ImportedScene imported = import("m.obj");
    const Scene scene = load(imported.text);
    ASSERT_EQ(scene.triangles.size(), 10u);
    const auto material = [&](std::size_t i) {
        return scene.materials[std::size_t(scene.triangles[i].tags.material)];
    };
    EXPECT_EQ(material(0).reflectance, Vec3(0.5f)) << "faces before the first usemtl";
    EXPECT_EQ(material(1).kind, MaterialKind::diffuse);
    EXPECT_EQ(material(1).reflectance, Vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(material(3).kind, MaterialKind::glass);
    EXPECT_EQ(material(3).ior, 1.25f);
    EXPECT_EQ(material(3).reflectance, Vec3(0.5f, 0.75f, 1));
    EXPECT_EQ(material(4).emission, Vec3(4, 3, 2));
    EXPECT_EQ(material(5).kind, MaterialKind::mirror);
    EXPECT_EQ(material(5).reflectance, Vec3(0.75f, 0.5f, 0.25f));
    EXPECT_EQ(material(6).kind, MaterialKind::phong);
    EXPECT_EQ(material(6).exponent, 50);
    EXPECT_EQ(material(6).specular, Vec3(0.5f, 0.25f / 1.5f, 0.25f / 1.5f)) << "at most 1 together";
    ASSERT_GE(material(7).texture, 0);
    EXPECT_EQ(scene.texels[std::size_t(scene.textures[std::size_t(material(7).texture)].first)],
              Vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(material(8).texture, -1) << "no texture coordinates, no picture";
    EXPECT_THAT(imported.notes, Contains(HasSubstr("describes the material \"Lost\"")));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("\"Image\" stays the file's own")));
    EXPECT_THAT(imported.text, testing::Not(HasSubstr("environment"))) << "the lamp shines";
}

TEST_F(Import, KeepsTogetherWhatOneMaterialOfTheFileBecame) {
    Mesh mesh;
    mesh.positions = {DVec3(0, 0, 0), DVec3(1, 0, 0), DVec3(0, 1, 0)};
    for (const char* name : {"Wood", "Wood", "", "Wood", ""}) {
        mesh.materials.emplace_back();
        mesh.materials.back().name = name;
    }
    mesh.materials[0].source = mesh.materials[1].source = 7; // as triangles of a textured surface
    mesh.materials[3].source = 8;
    EXPECT_THAT(material_keys(mesh),
                testing::ElementsAre("Wood", "Wood", "material 2", "Wood 2", "material 4"));
    for (int i = 0; i < 5; ++i) {
        mesh.triangles.emplace_back();
        mesh.triangles.back().position = {0, 1, 2};
        mesh.triangles.back().material = i;
    }
    const ImportedScene imported = import_scene(mesh, "m.glb", "title");
    EXPECT_THAT(imported.text, HasSubstr("\"materials\": {\"Wood 2\": \"Wood 2\", \"material 2\": "
                                         "\"material 2\", \"material 4\": \"material 4\"}"));
    EXPECT_THAT(imported.notes, Contains(HasSubstr("\"Wood\" stays the file's own, which varies")));
}

TEST_F(Import, SaysWhichOfTheFilesMaterialsDoesNotExist) {
    write("m.mtl", "newmtl Wood\nKd 1 0 0\n");
    write("m.obj", "mtllib m.mtl\n" + square + "usemtl Wood\nf 1 2 3\n");
    std::string text = import("m.obj").text;
    text.replace(text.find("{\"Wood\": \"Wood\"}"), 16, "{\"Wod\": \"Wood\"}");
    try {
        load(text);
        FAIL() << "it loads";
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("/shapes/0/materials/Wod: the mesh file has no material "
                              "\"Wod\"; did you mean \"Wood\"?"));
    }
}

} // namespace
} // namespace raylab::app
