// glTF files that raylab does not read, and the sentence that says why and what to do.
#include "common/load/tests/gltf_maker.h"

#include <limits>

namespace raylab {
namespace {

const std::string good_rest =
    R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}])";

std::string good() { return one_triangle().gltf(good_rest); }

void expect_error(const std::string& file, const std::string& words) {
    const std::string message = error_of([&] { parse_made(file); });
    EXPECT_NE(message.find(words), message.npos) << message;
    EXPECT_EQ(message.find("not a valid glTF file"), message.npos) << message;
}

TEST(GltfRefused, OtherVersions) {
    parse_made(with(good(), R"("version":"2.0")", R"("version":"2.1")")); // a later 2.x is readable
    parse_made(with(good(), R"("version":"2.0")", R"("version":"2.0","minVersion":"2.0")"));
    expect_error(with(good(), R"("version":"2.0")", R"("version":"3.0")"),
                 "/asset/version: this is glTF 3.0, and raylab reads glTF 2.0");
    expect_error(with(good(), R"("version":"2.0")", R"("version":"2.1","minVersion":"2.1")"),
                 "/asset/minVersion: the file asks for a reader of glTF 2.1, and raylab reads 2.0");
    expect_error(with(good(), R"("version":"2.0")", R"("version":"two")"),
                 R"(/asset/version: expected a version such as "2.0", found "two")");
    // glTF 1.0 names its parts by objects.
    expect_error(R"({"asset":{"version":"1.0"},"buffers":{"b":{"byteLength":3}},"meshes":{}})",
                 "this is glTF 1.0, and raylab reads glTF 2.0; import the file in Blender");
    expect_error(R"({"asset":{"version":1},"buffers":{"b":{"byteLength":3}},"meshes":{}})",
                 "/asset: this is glTF 1.0");
    expect_error(R"({"asset":{},"buffers":{"b":{"byteLength":3}},"meshes":{}})",
                 "/asset: this is glTF 1.0");
    expect_error(std::string("glTF\1\0\0\0\x18\0\0\0\4\0\0\0\0\0\0\0{}  ", 24),
                 "m.gltf: this is glTF 1.0");
}

TEST(GltfRefused, CompressedGeometry) {
    // Named in extensionsUsed alone, with the numbers nowhere else.
    const std::string draco = with(
        with(with(good(), R"("bufferView":0,)", ""), R"("TEXCOORD_0":1})",
             R"("TEXCOORD_0":1},"extensions":{"KHR_draco_mesh_compression":{"bufferView":0}})"),
        R"("nodes")", R"("extensionsUsed":["KHR_draco_mesh_compression"],"nodes")");
    expect_error(draco, "/extensionsUsed/0: the geometry is compressed by Draco");
    expect_error(draco, R"(in Blender, import it, and export it with "Compression" off)");
    const std::string meshopt =
        R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_meshopt_compression"],
        "buffers":[{"byteLength":4,"uri":"data:application/octet-stream;base64,AAAAAA=="},
        {"byteLength":36,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}]})";
    expect_error(meshopt, "/extensionsUsed/0: the geometry is compressed by meshoptimizer");
    expect_error(
        with(good(), R"("nodes")", R"("extensionsRequired":["KHR_texture_basisu"],"nodes")"),
        "/extensionsRequired/0: the textures are KTX2 files (KHR_texture_basisu), which "
        "raylab does not read; export them as PNG or JPEG");
    // With the numbers there, the file is read.
    EXPECT_EQ(parse_made(with(good(), R"("nodes")",
                              R"("extensionsUsed":["KHR_draco_mesh_compression"],"nodes")"))
                  .triangles.size(),
              1u);
}

TEST(GltfRefused, SkinsThatSayNothing) {
    const std::string bound =
        with(good(), R"("nodes":[{"mesh":0}])", R"("nodes":[{"mesh":0,"skin":0}],"skins":[{}])");
    expect_error(bound, "/skins/0: expected joints: a skin is a list of the nodes that move it");
    expect_error(with(bound, R"("skins":[{}])", R"("skins":[])"),
                 "/nodes/0: skin 0 does not exist; the file has 0");
    expect_error(with(bound, R"("skins":[{}])", R"("skins":[{"joints":[7]}])"),
                 "/skins/0/joints/0: the joint 7 is no node of the file's scene");
    // A skin that no node uses does not make the file wrong.
    EXPECT_EQ(parse_made(with(bound, R"(,"skin":0)", "")).triangles.size(), 1u);
}

TEST(GltfRefused, NumbersThatAreNotFiniteNameTheirAccessor) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    const auto file = [&](float position, float uv, float normal, float colour) {
        GltfMaker maker;
        maker.floats("VEC3", {0, 0, 0, 1, position, 0, 0, 1, 0});
        maker.floats("VEC2", {0, 0, 1, 0, 0, uv});
        maker.floats("VEC3", {normal, 0, 1, 0, 0, 1, 0, 0, 1});
        maker.floats("VEC3", {1, 1, 1, 1, colour, 1, 1, 1, 1});
        return maker.gltf(
            R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"NORMAL":2,"COLOR_0":3}}]}])");
    };
    parse_made(file(0, 3.4e38f, 1, 0));
    expect_error(file(nan, 0, 0, 0),
                 "/accessors/0: expected finite numbers, found nan in position 1");
    expect_error(file(0, infinity, 0, 0),
                 "/accessors/1: expected finite numbers, found inf in texture coordinate 2");
    expect_error(file(0, nan, 0, 0),
                 "/accessors/1: expected finite numbers, found nan in texture coordinate 2");
    expect_error(file(0, 0, nan, 0),
                 "/accessors/2: expected finite numbers, found nan in normal 0");
    expect_error(file(0, 0, 0, nan),
                 "/accessors/3: expected finite numbers, found nan in colour 1");
}

TEST(GltfRefused, TexturesThatLeadNowhere) {
    const auto file = [](const std::string& rest) {
        return triangle_file(one_triangle(), "",
                             R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})", rest);
    };
    expect_error(file(""), "baseColorTexture/index: textures 0 does not exist; the file has 0");
    expect_error(file(R"("textures":[{"source":1}],"images":[{"uri":"x.png"}])"),
                 "/textures/0/source: images 1 does not exist; the file has 1");
    expect_error(file(R"("textures":[{}])"), "the texture has no image in a format of glTF's core");
    expect_error(file(R"("textures":[{"source":0,"sampler":0}],"images":[{"uri":"x.png"}],
        "samplers":[{"wrapS":1}])"),
                 "/samplers/0/wrapS: expected 10497 (repeat), 33071 (clamp to edge) or 33648");
    expect_error(file(R"("textures":[{"source":0}],"images":[{"uri":"x.png"}])"),
                 "there is no file x.png");
}

} // namespace
} // namespace raylab
