// Task 1.1: camera rays, held against the geometry of a pinhole and of a thin lens.
#include "common/task/facts.h"
#include "labs/01_recursive/camera.h"

namespace raylab::lab01 {

namespace {

using namespace task;

// Looks along -z; the image is 8 x 4 pixels and twice as wide as high.
Camera pinhole() {
    Camera camera{};
    camera.position = Vec3(1, 2, 3);
    camera.right = Vec3(1, 0, 0);
    camera.up = Vec3(0, 1, 0);
    camera.forward = Vec3(0, 0, -1);
    camera.half_width = 1;
    camera.half_height = 0.5f;
    camera.width = 8;
    camera.height = 4;
    return camera;
}

TEST(Task1_1, TheCentreOfTheImageIsStraightAhead) {
    const Ray ray = camera_ray(pinhole(), 4, 2, Vec2(0), Vec2(0));
    expect_vector("origin of the ray through the image's centre", ray.o, Vec3(1, 2, 3), 1e-6,
                  "a pinhole camera's rays all start at its position");
    expect_vector("direction of the ray through the image's centre", ray.d, Vec3(0, 0, -1), 1e-6,
                  "pixel (x, y) covers [x, x + 1) of `width` pixels: the centre is at width / 2");
}

TEST(Task1_1, CornersOfTheImageAreCornersOfTheView) {
    const Camera camera = pinhole();
    const auto corner = [](float x, float y) { return normalize(Vec3(x, y, -1)); };
    expect_vector("direction of the top left corner", camera_ray(camera, 0, 0, Vec2(0), Vec2(0)).d,
                  corner(-1, 0.5f), 1e-6,
                  "row 0 is the top: y of the image runs down, `up` runs up");
    expect_vector("direction of the bottom right corner",
                  camera_ray(camera, 8, 4, Vec2(0), Vec2(0)).d, corner(1, -0.5f), 1e-6,
                  "half_width and half_height are half the image's size at distance 1");
}

TEST(Task1_1, TheRandomNumberMovesTheRayWithinItsPixel) {
    const Camera camera = pinhole();
    expect_vector("direction at the middle of pixel (6, 1)",
                  camera_ray(camera, 6, 1, Vec2(0.5f, 0.5f), Vec2(0)).d,
                  normalize(Vec3(0.625f, 0.125f, -1)), 1e-6,
                  "u_film is added to the pixel, in pixels, before anything is scaled");
    expect_vector("direction at (3/4, 1/4) of pixel (6, 1)",
                  camera_ray(camera, 6, 1, Vec2(0.75f, 0.25f), Vec2(0)).d,
                  normalize(Vec3(0.6875f, 0.1875f, -1)), 1e-6, "u_film.x and u_film.y swapped");
}

TEST(Task1_1, DirectionsAreUnitVectors) {
    for (const float lens_radius : {0.0f, 0.25f}) {
        Camera camera = pinhole();
        camera.lens_radius = lens_radius;
        camera.focus_distance = 7;
        const Ray ray = camera_ray(camera, 0, 3, Vec2(0.3f, 0.9f), Vec2(0.1f, 0.8f));
        if (!expect_near("length of a ray's direction", length(ray.d), 1, 1e-6,
                         "the direction is not normalised"))
            break;
    }
}

TEST(Task1_1, AllRaysOfAPointMeetInThePlaneInFocus) {
    Camera camera = pinhole();
    camera.lens_radius = 0.25f;
    camera.focus_distance = 4;
    const Vec3 expected = camera.position + 4.0f * Vec3(0.625f, 0.125f, -1);
    float leftmost = 0, rightmost = 0, lowest = 0, highest = 0;
    for (int i = 0; i < 64; ++i) {
        const int column = i % 8, row = i / 8;
        const Vec2 u_lens((column + 0.5f) / 8, (row + 0.5f) / 8);
        const Ray ray = camera_ray(camera, 6, 1, Vec2(0.5f), u_lens);
        const Vec3 from_centre = ray.o - camera.position;
        if (!expect_near("distance of a ray's origin from the lens's plane", from_centre.z, 0, 1e-6,
                         "the lens lies in the plane of `right` and `up`") ||
            !expect(length(from_centre) <= 0.25f * 1.000001f,
                    fmt::format("a ray starts {:.4g} from the middle of a lens of radius 0.25; "
                                "the likely cause: the disk's point is not scaled by lens_radius",
                                length(from_centre))) ||
            !expect_vector("point where a ray meets the plane in focus",
                           ray(4 / std::fmax(-ray.d.z, 1e-3f)), expected, 1e-5,
                           "the plane in focus is focus_distance along `forward`, and every ray "
                           "of the pixel goes through its one point there"))
            return;
        leftmost = std::min(leftmost, from_centre.x),
        rightmost = std::max(rightmost, from_centre.x);
        lowest = std::min(lowest, from_centre.y), highest = std::max(highest, from_centre.y);
    }
    expect(std::min({-leftmost, rightmost, -lowest, highest}) > 0.15f,
           fmt::format("64 rays start only between ({:.3g}, {:.3g}) and ({:.3g}, {:.3g}) of a lens "
                       "of radius 0.25; the likely cause: u_lens is not used for both coordinates",
                       leftmost, lowest, rightmost, highest));
}

} // namespace

} // namespace raylab::lab01
