// glTF files made here, byte by byte.
#include "common/image/display.h"
#include "common/load/mesh.h"
#include "common/load/tests/scene_files.h"

#include <fmt/format.h>

#include <cstdint>

namespace raylab {
namespace {

// A file of one buffer: `views` "offset length stride", the rest as JSON.
std::string gltf_json(const std::string& views, const std::string& accessors,
                      const std::string& rest, std::size_t bytes, const std::string& uri = "") {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}{}}}],"bufferViews":[{}],"accessors":[{}],{}}})",
        bytes, uri.empty() ? "" : ",\"uri\":\"" + uri + "\"", views, accessors, rest);
}

std::string word(std::size_t value) {
    return {char(value & 255), char(value >> 8 & 255), char(value >> 16 & 255),
            char(value >> 24 & 255)};
}

std::string glb(std::string json, std::string data) {
    while (json.size() % 4) json += ' ';
    while (data.size() % 4) data += '\0';
    return "glTF" + word(2) + word(28 + json.size() + data.size()) + word(json.size()) + "JSON" +
           json + word(data.size()) + std::string("BIN\0", 4) + data;
}

Mesh parse(const std::string& bytes) {
    return parse_gltf(bytes, "m.gltf", [](const std::string& name) -> std::string {
        throw SceneError("there is no file " + name);
    });
}

// Four vertices of the unit square in the plane z = 0, each with the normal (0, 0, 1) behind it.
const std::string square =
    little_endian({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1});
const std::string square_views =
    R"({"buffer":0,"byteLength":96,"byteStride":24},{"buffer":0,"byteOffset":96,"byteLength":INDEX_BYTES})";
const std::string square_accessors =
    R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
    {"bufferView":0,"byteOffset":12,"componentType":5126,"count":4,"type":"VEC3"},
    {"bufferView":1,"componentType":INDEX_TYPE,"count":INDEX_COUNT,"type":"SCALAR"})";
const std::string square_rest =
    R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"mode":4}]}])";

// The square with these indices in this width.
std::string square_file(const std::string& index_bytes, int type, int count,
                        const std::string& rest = square_rest) {
    const std::string views = with(square_views, "INDEX_BYTES", std::to_string(index_bytes.size()));
    const std::string accessors = with(with(square_accessors, "INDEX_TYPE", std::to_string(type)),
                                       "INDEX_COUNT", std::to_string(count));
    return glb(gltf_json(views, accessors, rest, 96 + index_bytes.size()), square + index_bytes);
}

const std::string two_triangles("\0\1\2\0\2\3", 6);

double signed_area(const Mesh& mesh) { // seen from +z
    double sum = 0;
    for (int t = 0; t < int(mesh.triangles.size()); ++t)
        sum +=
            cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0))
                .z /
            2;
    return sum;
}

TEST(Gltf, ReadsIndicesOfEveryWidthThroughAStride) {
    std::string u16, u32;
    for (const char c : two_triangles) {
        u16 += c + std::string(1, '\0');
        u32 += c + std::string(3, '\0');
    }
    for (const std::string& file : {square_file(two_triangles, 5121, 6), square_file(u16, 5123, 6),
                                    square_file(u32, 5125, 6)}) {
        const Mesh mesh = parse(file);
        ASSERT_EQ(mesh.triangles.size(), 2u);
        EXPECT_EQ(mesh.triangles[1].position, (std::array{0, 2, 3}));
        EXPECT_EQ(mesh.positions[3], DVec3(0, 1, 0));
        EXPECT_EQ(mesh.normals[mesh.triangles[1].normal[1]], DVec3(0, 0, 1));
        EXPECT_DOUBLE_EQ(signed_area(mesh), 1);
    }
}

TEST(Gltf, ReadsTrianglesWithoutIndicesOrNormals) {
    const std::string data = little_endian({0, 0, 0, 2, 0, 0, 0, 2, 0});
    const Mesh mesh = parse(glb(
        gltf_json(
            R"({"buffer":0,"byteLength":36})",
            R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})",
            R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])",
            36),
        data));
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.triangles[0].normal, (std::array{-1, -1, -1}));
    EXPECT_DOUBLE_EQ(signed_area(mesh), 2);
}

TEST(Gltf, TurnsStripsAndFansTheRightWayRound) {
    const auto mode = [](int m) {
        return with(square_rest, "\"mode\":4", "\"mode\":" + std::to_string(m));
    };
    EXPECT_DOUBLE_EQ(signed_area(parse(square_file(std::string("\0\1\3\2", 4), 5121, 4, mode(5)))),
                     1); // strip: with a wrong turn 0
    EXPECT_DOUBLE_EQ(signed_area(parse(square_file(std::string("\0\1\2\3", 4), 5121, 4, mode(6)))),
                     1); // fan
}

TEST(Gltf, AppliesTheNodesTransformsFromTheRootDown) {
    // Turn by 90 degrees about z, stretch x by 3 (before the turn), move; the child moves by (1, 0,
    // 0) first.
    const std::string nodes = R"("scene":0,"scenes":[{"nodes":[1]}],"nodes":[{"mesh":0,PLACE},
        {"children":[0],"rotation":[0,0,0.70710678118654752,0.70710678118654752],"scale":[3,1,1],"translation":[0,0,5]}],"meshes")";
    const auto file = [&](const std::string& place) {
        return square_file(
            two_triangles, 5121, 6,
            with(with(square_rest, R"("nodes":[{"mesh":0}],"meshes")", nodes), "PLACE", place));
    };
    const Mesh trs = parse(file(R"("translation":[1,0,0])"));
    const Mesh matrix = parse(file(R"("matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 1,0,0,1])"));
    for (const Mesh* mesh : {&trs, &matrix}) {
        // (1,0,0) -> (2,0,0) -> (6,0,0) -> (0,6,0) -> (0,6,5)
        const DVec3 p = mesh->positions[1];
        EXPECT_NEAR(p.x, 0, 1e-12);
        EXPECT_NEAR(p.y, 6, 1e-12);
        EXPECT_NEAR(p.z, 5, 1e-12);
        EXPECT_NEAR(signed_area(*mesh), 3, 1e-12);
    }
    const Mesh mirrored = parse(file(R"("scale":[-1,1,1])"));
    EXPECT_NEAR(signed_area(mirrored), 3, 1e-12) << "a mirrored node turns its triangles over";
    EXPECT_GT(mirrored.normals[0].z, 0);
}

TEST(Gltf, TakesBaseColoursAndImages) {
    const std::string image = png(1, 1, std::string("\xff\x80\0", 3));
    std::string data =
        little_endian({0, 0, 0, 2, 0, 0, 0, 2, 0, /* uv */ 0, 0, 1, 0, 0, 1}) + image;
    const std::string file = glb(
        gltf_json(
            R"({"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},{"buffer":0,"byteOffset":60,"byteLength":)" +
                std::to_string(image.size()) + "}",
            R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"})",
            R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
           "materials":[{"name":"skin","pbrMetallicRoughness":{"baseColorFactor":[0.5,1,0.25,1],"baseColorTexture":{"index":0}}}],
           "textures":[{"source":0}],"images":[{"bufferView":2,"mimeType":"image/png"}])",
            data.size()),
        data);
    const Mesh mesh = parse(file);
    EXPECT_EQ(mesh.uvs[0], Vec2(0, 1)) << "v = 0 is the top of a glTF image";
    ASSERT_EQ(mesh.pictures.size(), 1u);

    TemporaryFolder folder;
    folder.write("m.glb", file);
    const Scene scene = load(scene_of_shapes(R"({"kind": "mesh", "file": "m.glb"})"), folder);
    EXPECT_EQ(scene.material_names.back(), "skin");
    EXPECT_EQ(scene.materials[scene.triangles.at(0).tags.material].texture, 0);
    EXPECT_EQ(scene.texels.at(0).x, 0.5f);
    EXPECT_EQ(scene.texels[0].y, linear_from_srgb(128 / 255.0));
    EXPECT_EQ(scene.texels[0].z, 0);
    EXPECT_EQ(scene.corners.at(0).normal[0], Vec3(0, 0, 1));
    const Scene other = load(
        scene_of_shapes(R"({"kind": "mesh", "file": "m.glb", "material": "lamp", "smooth": true})"),
        folder);
    EXPECT_EQ(other.lights.at(0).kind, LightKind::triangle)
        << "the shape's material replaces the file's";
}

TEST(Gltf, ReadsBuffersFromFilesAndFromTheText) {
    const std::string
        views = R"({"buffer":0,"byteLength":36})",
        accessors = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})",
        rest = R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
    const std::string text = gltf_json(views, accessors, rest, 36, "part%201.bin");
    std::string asked;
    const Mesh mesh = parse_gltf(text, "m.gltf", [&](const std::string& name) {
        asked = name;
        return little_endian({0, 0, 0, 1, 0, 0, 0, 1, 0});
    });
    EXPECT_EQ(asked, "part 1.bin");
    EXPECT_DOUBLE_EQ(signed_area(mesh), 0.5);
    EXPECT_NE(error_of([&] { parse(text); }).find("there is no file part 1.bin"),
              std::string::npos);
    // 36 zero bytes
    const Mesh embedded =
        parse(gltf_json(views, accessors, rest, 36,
                        "data:application/octet-stream;base64," + std::string(48, 'A')));
    EXPECT_EQ(embedded.positions.at(2), DVec3(0));
}

TEST(Gltf, MalformedFilesAreErrorsWithTheirPlace) {
    const std::string good = square_file(two_triangles, 5121, 6);
    const auto message = [&](const std::string& from, const std::string& to) {
        EXPECT_EQ(from.size(), to.size()) << "the chunk's length must stay";
        return error_of([&] { parse(with(good, from, to)); });
    };
    const auto expect = [](const std::string& text, const std::string& words) {
        EXPECT_NE(text.find(words), text.npos) << text;
        EXPECT_TRUE(text.starts_with("m.gltf")) << text;
    };
    expect(message("\"count\":4", "\"count\":5"),
           "/accessors/0: expected 5 elements of 12 bytes, 24 apart from byte 0 on, within the 96 "
           "bytes of bufferView 0");
    expect(message("\"byteOffset\":12", "\"byteOffset\":99"), "/accessors/1: expected 4 elements");
    expect(message("\"byteOffset\":96", "\"byteOffset\":99"),
           "/bufferViews/1/byteLength: expected bytes within buffer 0, which has 102, found 6 "
           "bytes at 99");
    expect(message("\"buffer\":0", "\"buffer\":7"),
           "/bufferViews/0/buffer: expected one of the file's 1 buffers");
    expect(message("\"mesh\":0", "\"mesh\":3"), "/nodes/0: mesh 3 does not exist; the file has 1");
    expect(message("\"POSITION\":0", "\"POSITION\":9"),
           "/meshes/0: the accessor 9 of POSITION does not exist");
    expect(message("\"POSITION\":0", "\"POSITION\":2"),
           "/meshes/0: expected POSITION of 3 components, found 1");
    expect(message("\"POSITION\"", "\"POSITIOM\""), "/meshes/0: expected an attribute POSITION");
    expect(message("\"indices\":2", "\"indices\":0"),
           "/accessors/0: expected indices of type SCALAR");
    expect(message(two_triangles, std::string("\0\1\2\0\2\4", 6)),
           "/accessors/2: index 5 is 4, but the primitive has 4 vertices");
    expect(message("{\"asset\"", "{\"osset\""),
           "m.gltf (its JSON chunk):1:1: /: expected a key \"asset\"");
    expect(error_of([&] { parse(good.substr(0, good.size() - 4)); }),
           "m.gltf: expected " + std::to_string(good.size()) + " bytes, as the file's header says");
    expect(error_of([&] { parse("glTF"); }), "expected a binary glTF file");
    expect(error_of([&] { parse("{}"); }), "m.gltf:1:1: /: expected a key \"asset\"");
    const auto rest = [&](const std::string& from, const std::string& to) {
        return error_of(
            [&] { parse(square_file(two_triangles, 5121, 6, with(square_rest, from, to))); });
    };
    expect(
        rest("\"nodes\":[{", R"("extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{)"),
        "/extensionsRequired/0: the geometry is compressed by Draco");
    expect(rest("\"nodes\":[{", R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[0],)"),
           "/nodes/0: this node is the child of two nodes or of itself");
    expect(rest("\"nodes\":[{", R"("scenes":[{"nodes":[4]}],"nodes":[{)"),
           "/nodes: node 4 does not exist; the file has 1");
    expect(rest("\"mode\":4", "\"mode\":4,\"material\":2"), "/meshes/0: material 2 does not exist");
    expect(rest("\"mode\":4", "\"mode\":4,\"material\":-5"),
           "/meshes/0: material -5 does not exist");
    expect(rest("\"mode\":4", "\"mode\":1"), "m.gltf: expected triangles in its scene, found none");
}

} // namespace
} // namespace raylab
