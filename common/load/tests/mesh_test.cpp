// OBJ files, smooth normals, and how a mesh enters the scene.
#include "common/load/mesh.h"

#include "common/load/tests/scene_files.h"

#include <fmt/format.h>

#include <numbers>

namespace raylab {
namespace {

double area(const Mesh& mesh) {
    double sum = 0;
    for (const MeshTriangle& t : mesh.triangles) {
        const DVec3 a = mesh.positions[t.position[0]], b = mesh.positions[t.position[1]],
                    c = mesh.positions[t.position[2]];
        const DVec3 n = cross(b - a, c - a);
        sum += std::sqrt(dot(n, n)) / 2;
    }
    return sum;
}

const std::string cube = R"(v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
v 0 0 1
v 1 0 1
v 0 1 1
v 1 1 1
f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6
)";

TEST(Obj, CutsPolygonsIntoTrianglesOfTheSameArea) {
    const Mesh pentagon =
        parse_obj("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 1 0\nv 0 2 0\nf 1 2 3 4 5\n", "m.obj");
    EXPECT_EQ(pentagon.triangles.size(), 3u);
    EXPECT_DOUBLE_EQ(area(pentagon),
                     3); // a square of 4 without a notch of 1; a fan gives 4 or more
    EXPECT_DOUBLE_EQ(area(parse_obj(cube, "m.obj")), 6);
}

TEST(Obj, CountsNegativeIndicesFromTheEnd) {
    const Mesh a = parse_obj(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25\nvn 0 0 2\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\nv 9 9 9\n",
        "m.obj");
    const Mesh b = parse_obj("v 0 0 0\r\nv 1 0 0\rv 0 1 0\nvt .5 +2.5e-1\nvn 0 0 2 # up\n  f 1/1/1 "
                             "2/1/1 3/1/1\nl 1 2\nusemtl x\ng y\nv 9 9 9",
                             "m.obj");
    for (const Mesh* mesh : {&a, &b}) {
        ASSERT_EQ(mesh->triangles.size(), 1u);
        EXPECT_EQ(mesh->triangles[0].position, (std::array{0, 1, 2}));
        EXPECT_EQ(mesh->triangles[0].normal, (std::array{0, 0, 0}));
        EXPECT_EQ(mesh->triangles[0].uv, (std::array{0, 0, 0}));
        EXPECT_EQ(mesh->uvs[0], Vec2(0.5f, 0.25f));
        EXPECT_EQ(mesh->positions.size(), 4u);
    }
}

// The corners of the only triangle: vertex, texture coordinate, normal.
std::array<std::array<int, 3>, 3> only_triangle(const std::string& text) {
    const Mesh mesh = parse_obj(text, "m.obj");
    if (mesh.triangles.size() != 1) return {};
    const MeshTriangle& t = mesh.triangles[0];
    return {t.position, t.uv, t.normal};
}

TEST(Obj, IsReadHoweverItsLinesAreWritten) {
    const std::array<std::array<int, 3>, 3> none{{{0, 1, 2}, {-1, -1, -1}, {-1, -1, -1}}},
        uvs{{{0, 1, 2}, {0, 0, 1}, {-1, -1, -1}}}, all{{{0, 1, 2}, {0, 0, 1}, {0, 0, 0}}};
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n";
    EXPECT_EQ(only_triangle("\xEF\xBB\xBF" + points + "f 1 2 3"), none) << "byte order mark";
    EXPECT_EQ(only_triangle("\xEF\xBB\xBFv 0 0 0\rv 1 0 0\r\nv 0 1 0\rf 1 2 3\r"), none);
    EXPECT_EQ(only_triangle("v 0 \\\n0 0\nv\\\r\n1 0 0\nv 0 1 0\nf 1 2 \\ \n\\\n3"), none);
    EXPECT_EQ(only_triangle(points + "f 1// 2// 3//"), none);
    EXPECT_EQ(only_triangle(points + "f 1/ 2/ 3/"), none);
    EXPECT_EQ(only_triangle(points + "f 1/1/ 2/1/ 3/2/"), uvs);
    EXPECT_EQ(only_triangle(points + "\tf\t1/1/1\t 2/1/1 3/2/1 \t"), all);
    EXPECT_EQ(only_triangle(points + "f -3/-2/-1 -2/-2/-1 -1/-1/-1 # comment \\\n"), all);
    EXPECT_EQ(only_triangle("f 1 2 3\nv 0 0 0\nv 1e-400 +1. -.5\nv 0 1 0\n"), none) << "v after f";
    const std::string long_line = "g " + std::string(1 << 20, 'x') + "\n";
    EXPECT_EQ(only_triangle(long_line + points + "f" + std::string(1 << 20, ' ') + "1 2 3"), none);
}

TEST(Obj, KeepsNumbersInDouble) {
    const Mesh mesh = parse_obj("v 500000.123 1e-320 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj");
    EXPECT_EQ(mesh.positions.at(0), DVec3(500000.123, 1e-320, 0));
}

TEST(Obj, WithoutTheTextureCoordinatesOrNormalsItNamesGoesWithout) {
    const std::array<std::array<int, 3>, 3> none{{{0, 1, 2}, {-1, -1, -1}, {-1, -1, -1}}};
    EXPECT_EQ(only_triangle("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2/1/-1 3/9/0\n"), none);
    const Mesh mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2/1/1 3/1/1\nf 1 2\n", "m.obj");
    EXPECT_EQ(mesh.warnings,
              (std::vector<std::string>{
                  "m.obj: 1 faces have fewer than 3 corners and are left out",
                  "m.obj: 6 corners name texture coordinates or normals that the file does not "
                  "have; their faces go without"}));
}

TEST(Obj, CutsLargePolygonsAndThoseWithNotches) {
    std::string disc = "f";
    for (int i = 1; i <= 1000; ++i) disc += " " + std::to_string(i);
    for (int i = 0; i < 1000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 1000;
        disc += fmt::format("\nv {} {} 0", std::cos(angle), std::sin(angle));
    }
    EXPECT_NEAR(area(parse_obj(disc, "m.obj")), 500 * std::sin(2 * std::numbers::pi / 1000), 1e-9);
    EXPECT_DOUBLE_EQ(area(parse_obj("v 0 -1 0\nv 6 -1 0\nv 3 0 0\nv 2 10 0\nv 1 0 0\nv 0 10 0\n"
                                    "f 1 2 3 4 5 6\n",
                                    "m.obj")),
                     19.5);
}

TEST(Obj, SaysWhichLineIsWrong) {
    const auto message = [](const std::string& lines) {
        return error_of([&] { parse_obj(lines, "m.obj"); });
    };
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(message("v 0 0\n"), "m.obj:1:1: expected 3 numbers after v, found 2");
    EXPECT_EQ(message("v 0 0 zero\n"), "m.obj:1:7: expected a number, found \"zero\"");
    EXPECT_EQ(message("v 0 0 1,5\n"), "m.obj:1:7: expected a number, found \"1,5\"");
    EXPECT_EQ(message("v 0 0 nan\n"),
              "m.obj:1:7: expected a finite number in single precision, found nan");
    EXPECT_EQ(message("v 0 1e99 0\n"),
              "m.obj:1:5: expected a finite number in single precision, found 1e99");
    EXPECT_EQ(message("v 0 1e999 0\n"),
              "m.obj:1:5: expected a finite number in single precision, found 1e999");
    EXPECT_EQ(message("v 0 0 -inf\n"),
              "m.obj:1:7: expected a finite number in single precision, found -inf");
    EXPECT_EQ(message(three + "f 1 2 4\n"),
              "m.obj:4:7: vertex 4 does not exist; the file has 3, counted from 1");
    EXPECT_EQ(message(three + "f 1 2 -4\n"), "m.obj:4:7: vertex -4 does not exist; 3 are defined "
                                             "above this line, counted from 1, or back from -1");
    EXPECT_EQ(message(three + "f 0 1 2\n"),
              "m.obj:4:3: vertex 0 does not exist; 3 are defined above "
              "this line, counted from 1, or back from -1");
    EXPECT_EQ(message(three + "f 1 \\\n2 9\n"),
              "m.obj:5:3: vertex 9 does not exist; the file has 3, counted from 1");
    EXPECT_EQ(message(three + "f 1/2/3/4 2 3\n"),
              "m.obj:4:3: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found \"1/2/3/4\"");
    EXPECT_EQ(message(three + "f //1 2 3\n"),
              "m.obj:4:3: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found \"//1\"");
    EXPECT_EQ(message(three + "f 1 2 3x\n"),
              "m.obj:4:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found \"3x\"");
    EXPECT_EQ(message(three + "f 1 2 99999999999\n"),
              "m.obj:4:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found \"99999999999\"");
    EXPECT_EQ(message(three), "m.obj: expected faces (lines that begin with f), found none");
    EXPECT_EQ(message(""), "m.obj: expected faces (lines that begin with f), found none");
}

TEST(SmoothNormals, OfACubesCornersPointAlongItsDiagonals) {
    Mesh mesh = parse_obj(cube, "m.obj");
    compute_smooth_normals(mesh);
    bool naive_differs = false;
    for (const MeshTriangle& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const DVec3 n = mesh.normals[t.normal[i]],
                        out = mesh.positions[t.position[i]] - DVec3(0.5);
            EXPECT_NEAR(dot(n, out) / std::sqrt(dot(n, n) * dot(out, out)), 1, 1e-12);
            // Not weighted by angle, a face that its diagonal cuts here would count twice.
            DVec3 naive(0);
            for (const MeshTriangle& other : mesh.triangles)
                for (const int p : other.position)
                    if (p == t.position[i])
                        naive += cross(
                            mesh.positions[other.position[1]] - mesh.positions[other.position[0]],
                            mesh.positions[other.position[2]] - mesh.positions[other.position[0]]);
            naive_differs |= dot(naive, out) / std::sqrt(dot(naive, naive) * dot(out, out)) < 0.99;
        }
    EXPECT_TRUE(naive_differs);
}

TEST(SmoothNormals, JoinCornersThatAFileListsTwice) {
    // Two triangles of a roof, which share their ridge's positions but not their indices.
    Mesh mesh = parse_obj(
        "v 0 0 0\nv 0 1 1\nv 1 0 1\nv 0 1 1\nv 1 0 1\nv 1 1 0\nf 1 3 2\nf 4 5 6\n", "m.obj");
    compute_smooth_normals(mesh);
    EXPECT_EQ(mesh.normals[mesh.triangles[0].normal[2]], mesh.normals[mesh.triangles[1].normal[0]]);
    EXPECT_EQ(mesh.normals[mesh.triangles[0].normal[1]], mesh.normals[mesh.triangles[1].normal[1]]);
}

Scene mesh_scene(const std::string& obj, const std::string& more,
                 const std::string& material = "\"lamp\"") {
    TemporaryFolder folder;
    folder.write("m.obj", obj);
    folder.write("t.png", png(2, 2,
                              std::string("\xff\0\0"
                                          "\0\xff\0"
                                          "\0\0\xff"
                                          "\xbc\xbc\xbc",
                                          12)));
    std::string text = scene_of_shapes(R"({"kind": "mesh", "file": "m.obj", "material": )" +
                                       material + more + "}");
    return load(with(text, "\"white\": {",
                     R"("image": {"kind": "diffuse", "reflectance_texture": "t.png"}, "white": {)"),
                folder);
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nvt 0 0\nvt 1 0\nvt 0 1\n";

TEST(MeshShape, HasCornersOnlyWhereNormalsOrTextureCoordinatesMatter) {
    const std::string with_both = triangle + "f 1/1/1 2/2/1 3/3/1\n", bare = triangle + "f 1 2 3\n";
    EXPECT_EQ(mesh_scene(bare, "").triangles[0].corners, -1);
    EXPECT_EQ(mesh_scene(with_both, R"(, "smooth": false)").triangles[0].corners, -1);
    EXPECT_EQ(mesh_scene(with_both, "").corners.at(0).normal[1], Vec3(0.6f, 0, 0.8f));
    EXPECT_EQ(mesh_scene(bare, R"(, "smooth": true)").corners.at(0).normal[1], Vec3(0, 0, 1));
    // A normal of no length says nothing: the geometric one stands in for it.
    EXPECT_EQ(
        mesh_scene("vn 0 0 0\n" + triangle + "f 1//1 2//2 3//1\n", "").corners.at(0).normal[0],
        Vec3(0, 0, 1));
    const Scene textured = mesh_scene(with_both, R"(, "smooth": false)", "\"image\"");
    EXPECT_EQ(textured.corners.at(0).normal[0], Vec3(0, 0, 1)) << "flat: the geometric normal";
    EXPECT_EQ(textured.corners.at(0).uv[1], Vec2(1, 0));
    EXPECT_NE(error_of([&] {
                  mesh_scene(bare, "", "\"image\"");
              }).find("the mesh has no texture coordinates"),
              std::string::npos);
}

TEST(MeshShape, IsMirroredWithItsNormalsOutward) {
    const Scene scene = mesh_scene(
        cube, R"(, "smooth": true, "transform": {"scale": [-1, 2, 3], "translate": [1, 0, 0]})");
    ASSERT_EQ(scene.triangles.size(), 12u);
    for (const Triangle& t : scene.triangles) {
        const Vec3 middle(0.5f, 1, 1.5f);
        EXPECT_GT(dot(t.normal, t.v[0] - middle), 0);
        EXPECT_NEAR(dot(normalize(cross(t.v[1] - t.v[0], t.v[2] - t.v[0])), t.normal), 1, 1e-6);
        for (int i = 0; i < 3; ++i) {
            // The cube's (1,1,1) under the inverse transpose of diag(-1, 2, 3), at that very
            // corner.
            const Vec3 out = glm::sign(t.v[i] - middle);
            EXPECT_NEAR(
                dot(scene.corners[t.corners].normal[i], normalize(out * Vec3(1, 0.5f, 1 / 3.0f))),
                1, 1e-6);
        }
    }
}

TEST(Texture, IsLinearAndItsFirstRowIsTheBottom) {
    const Scene scene = mesh_scene(triangle + "f 1/1 2/2 3/3\n", "", "\"image\"");
    ASSERT_EQ(scene.textures.size(), 1u);
    ASSERT_EQ(scene.texels.size(), 4u);
    EXPECT_EQ(scene.texels[0], Vec3(0, 0, 1)); // the file's second row
    EXPECT_EQ(scene.texels[2], Vec3(1, 0, 0));
    EXPECT_EQ(scene.texels[3], Vec3(0, 1, 0));
    // sRGB 188 is half the light, not 188/255 = 0.74 of it.
    EXPECT_NEAR(scene.texels[1].x, std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), 1e-7);
    EXPECT_NEAR(scene.texels[1].x, 0.5, 0.003);
}

} // namespace
} // namespace raylab
