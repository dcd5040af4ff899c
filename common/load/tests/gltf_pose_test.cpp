// Where the vertices of glTF files stand: skins, morph targets, instances, sparse accessors.
#include "common/load/tests/gltf_maker.h"

#include <fmt/format.h>

namespace raylab {
namespace {

const std::string triangle_mesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";

void expect_near(DVec3 a, DVec3 b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6);
}

TEST(GltfPose, SkinsFollowTheirJoints) {
    GltfMaker maker = one_triangle();
    const int normals = maker.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int joints = maker.accessor("VEC4", 5121, 3, std::string("\0\0\0\0\1\0\0\0\0\1\0\0", 12));
    // The third vertex hangs on both joints alike; weights that do not add up to 1 do not scale.
    const int weights = maker.floats("VEC4", {1, 0, 0, 0, 0.5f, 0, 0, 0, 0.25f, 0.25f, 0, 0});
    // The second joint's rest is at (1, 0, 0): its inverse bind matrix takes that to the origin.
    const int inverse = maker.floats("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                              1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
    const std::string attributes =
        fmt::format(R"("attributes":{{"POSITION":0,"NORMAL":{},"JOINTS_0":{},"WEIGHTS_0":{}}})",
                    normals, joints, weights);
    // Joint 1 stands at (1, 0, 0) and is turned by 90 degrees about x; the mesh's own node is
    // moved, which must not matter.
    const std::string file = maker.gltf(
        R"("nodes":[{"mesh":0,"skin":0,"translation":[50,0,0]},{"children":[2],"translation":[0,0,5]},
        {"translation":[1,0,0],"rotation":[0.70710678118654752,0,0,0.70710678118654752]}],
        "scenes":[{"nodes":[0,1]}],
        "skins":[{"joints":[1,2],"inverseBindMatrices":)" +
        std::to_string(inverse) + R"(}],"meshes":[{"primitives":[{)" + attributes + "}]}]");
    const Mesh mesh = parse_made(file);
    expect_near(corner(mesh, 0, 0), DVec3(0, 0, 5));
    expect_near(corner(mesh, 0, 1), DVec3(1, 0, 5)); // on the axis of the turn
    // (0, 1, 0) by joint 0: (0, 1, 5); by joint 1: (-1, 1, 0) turned (-1, 0, 1), moved (0, 0, 6).
    expect_near(corner(mesh, 0, 2), DVec3(0, 0.5, 5.5));
    const DVec3 n = mesh.normals[std::size_t(mesh.triangles[0].normal[1])]; // (0, 0, 1) turned
    expect_near(n / std::sqrt(dot(n, n)), DVec3(0, -1, 0));
}

TEST(GltfPose, MorphTargetsHaveTheirDefaultWeights) {
    GltfMaker maker = one_triangle();
    const int first = maker.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int second = maker.floats("VEC3", {4, 0, 0, 0, 0, 0, 0, 0, 0});
    const std::string mesh = fmt::format(
        R"("meshes":[{{"weights":[0.5,0.25],"primitives":[{{"attributes":{{"POSITION":0}},"targets":[{{"POSITION":{}}},{{"POSITION":{}}}]}}]}}])",
        first, second);
    const Mesh by_mesh = parse_made(maker.gltf(R"("nodes":[{"mesh":0}],)" + mesh));
    expect_near(corner(by_mesh, 0, 0), DVec3(1, 0, 0.5));
    expect_near(corner(by_mesh, 0, 2), DVec3(0, 1, 0.5));
    const Mesh by_node = parse_made(maker.gltf(R"("nodes":[{"mesh":0,"weights":[2,0]}],)" + mesh));
    expect_near(corner(by_node, 0, 0), DVec3(0, 0, 2));
}

TEST(GltfPose, InstancesArePlacedOneByOne) {
    GltfMaker maker = one_triangle();
    const int places = maker.floats("VEC3", {0, 0, 0, 10, 0, 0});
    const int sizes = maker.floats("VEC3", {1, 1, 1, 2, 3, -1});
    const Mesh mesh = parse_made(maker.gltf(fmt::format(
        R"("nodes":[{{"mesh":0,"translation":[0,0,7],"extensions":{{"EXT_mesh_gpu_instancing":{{"attributes":{{"TRANSLATION":{},"SCALE":{}}}}}}}}}],{})",
        places, sizes, triangle_mesh)));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    expect_near(corner(mesh, 0, 1), DVec3(1, 0, 7));
    expect_near(corner(mesh, 1, 0), DVec3(10, 0, 7));
    expect_near(corner(mesh, 1, 2), DVec3(12, 0, 7)); // mirrored, so turned over
    expect_near(corner(mesh, 1, 1), DVec3(10, 3, 7));
}

TEST(GltfPose, SparseAccessorsReplaceElements) {
    GltfMaker maker = one_triangle();
    const int indices = maker.view(std::string("\1\0\2\0", 4));
    const int values = maker.view(little_endian({5, 6, 7, 8, 9, 10}));
    const std::string sparse = fmt::format(
        R"("sparse":{{"count":2,"indices":{{"bufferView":{},"componentType":5123}},"values":{{"bufferView":{}}}}})",
        indices, values);
    const std::string nodes = R"("nodes":[{"mesh":0}],)" + triangle_mesh;
    const std::string over_view =
        with(maker.gltf(nodes), R"("type":"VEC3"})", R"("type":"VEC3",)" + sparse + "}");
    const Mesh mesh = parse_made(over_view);
    expect_near(corner(mesh, 0, 0), DVec3(0));
    expect_near(corner(mesh, 0, 1), DVec3(5, 6, 7));
    expect_near(corner(mesh, 0, 2), DVec3(8, 9, 10));
    // Without a view of its own the rest is zero.
    const Mesh alone = parse_made(with(over_view, R"("bufferView":0,)", ""));
    expect_near(corner(alone, 0, 0), DVec3(0));
    expect_near(corner(alone, 0, 2), DVec3(8, 9, 10));
    const std::string message =
        error_of([&] { parse_made(with(over_view, "\"count\":2,", "\"count\":3,")); });
    EXPECT_NE(message.find("/accessors/0: expected 3 elements of 2 bytes"), message.npos)
        << message;
}

} // namespace
} // namespace raylab
