// From scenes and mesh files to triangles and a camera.
#include "grader/bench/rays/ray_mesh.h"

#include "common/load/load.h"
#include "common/load/procedural/procedural.h"

#include <gmock/gmock.h>

#include <fstream>

namespace raylab::bench {
namespace {

using testing::HasSubstr;

// Where a point is on the film: -1 .. 1 both ways if it is in the picture.
Vec2 on_film(const Camera& camera, Vec3 p) {
    const Vec3 d = p - camera.position;
    const float depth = dot(d, camera.forward);
    EXPECT_GT(depth, 0);
    return Vec2(dot(d, camera.right) / depth / camera.half_width,
                dot(d, camera.up) / depth / camera.half_height);
}

Vec3 corner(const Bounds& b, int i) {
    return Vec3(i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y, i & 4 ? b.high.z : b.low.z);
}

TEST(RayMesh, HasASceneSQuadsAsTwoTrianglesAndSaysWhatItLeavesOut) {
    const Scene scene = load_scene(find_scene("fractal"));
    const RayMesh mesh = polygons_of(scene);
    EXPECT_EQ(mesh.triangles.size(), scene.triangles.size());
    EXPECT_EQ(mesh.left_out, "2 spheres, 1 planes");
    const Scene box = load_scene(find_scene("cornell"));
    const RayMesh room = polygons_of(box);
    EXPECT_EQ(room.triangles.size(), 2 * box.quads.size() + box.triangles.size());
    for (std::size_t i = 0; i < room.triangles.size(); ++i) {
        EXPECT_EQ(room.triangles[i].tags.id, int(i));
        EXPECT_NEAR(length(room.triangles[i].normal), 1, 1e-6f);
    }
}

TEST(RayMesh, WithoutTrianglesIsRefused) {
    EXPECT_THROW(polygons_of(load_scene(find_scene("white_furnace"))), SceneError);
    EXPECT_THROW(load_ray_mesh("/no/such.obj"), SceneError);
    const std::string path = testing::TempDir() + "flat.obj";
    std::ofstream(path) << "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n";
    try {
        load_ray_mesh(path);
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), HasSubstr("flat has no triangles with an area"));
    }
}

TEST(Views, FromTheFrontTheBoxSFrontFillsTheFilm) {
    const Bounds box = {Vec3(-1, 0, -1), Vec3(1, 2, 1)};
    const Camera camera = view_from_front(box);
    for (int i = 4; i < 8; ++i) { // z is high
        const Vec2 at = on_film(camera, corner(box, i));
        EXPECT_NEAR(std::fabs(at.x), 1, 1e-5f);
        EXPECT_NEAR(std::fabs(at.y), 1, 1e-5f);
    }
}

TEST(Views, FromAboveAProceduralMeshJustFitsIntoThePicture) {
    for (const ProceduralMesh& kind : procedural_meshes()) {
        if (kind.name == std::string("stadium")) continue; // seen from inside
        const RayMesh mesh = procedural_ray_mesh(kind.name, 300, 1);
        float outmost = 0;
        for (const Triangle& triangle : mesh.triangles)
            for (const Vec3& v : triangle.v) {
                const Vec2 at = on_film(mesh.camera, v);
                outmost = std::max({outmost, std::fabs(at.x), std::fabs(at.y)});
            }
        EXPECT_NEAR(outmost, 1, 1e-5f) << kind.name;
    }
}

TEST(Views, LookStraightDownToo) {
    const Camera camera = pinhole(DVec3(0, 5, 0), DVec3(0));
    EXPECT_NEAR(length(camera.right), 1, 1e-6f);
    EXPECT_NEAR(dot(camera.right, camera.forward), 0, 1e-6f);
}

} // namespace
} // namespace raylab::bench
