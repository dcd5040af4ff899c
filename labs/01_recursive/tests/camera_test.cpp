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

TEST(Task1_1, TheCentreOfTheImageIsStraightAhead) {
    const Ray ray = camera_ray(pinhole(), 4, 2, Vec2(0), Vec2(0));
    expect_vector("origin of the ray through the image's centre", ray.o, Vec3(1, 2, 3), 1e-6,
                  "a pinhole camera's rays all start at its position");
    expect_vector("direction of the ray through the image's centre", ray.d, Vec3(0, 0, -1), 1e-6,
                  "pixel (x, y) covers [x, x + 1) of `width` pixels and [y, y + 1) of `height` "
                  "pixels: the centre is at half of each, not of width - 1");
}

// At distance 1 the image reaches from (-1, -0.5) to (1, 0.5).
TEST(Task1_1, CornersOfTheImageAreCornersOfTheView) {
    const Camera camera = pinhole();
    const struct {
        const char* name;
        int x, y;
        float right, up;
    } corners[] = {{"top left", 0, 0, -1, 0.5f}, {"bottom right", 8, 4, 1, -0.5f}};
    for (const auto& corner : corners) {
        const Vec3 d = camera_ray(camera, corner.x, corner.y, Vec2(0), Vec2(0)).d;
        const float right = d.x / -d.z, up = d.y / -d.z;
        const auto what = [&](const char* which) {
            return fmt::format("{} of the {} corner at distance 1", which, corner.name);
        };
        const std::string size = "half_width and half_height are half the image's size at distance "
                                 "1: the tangent already, no angle";
        if (!expect_near(what("|x|"), std::fabs(right), 1, 1e-5, size) ||
            !expect_near(what("|y|"), std::fabs(up), 0.5, 1e-5, size) ||
            !expect_near(what("x"), right, corner.right, 1e-5,
                         "column 0 is at the left: x of the image runs along `right`") ||
            !expect_near(what("y"), up, corner.up, 1e-5,
                         "row 0 is the top: y of the image runs down, `up` runs up"))
            return;
    }
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

// Looks straight down, and `up` is no axis.
TEST(Task1_1, TheCameraMayBeTurned) {
    Camera camera = pinhole();
    camera.forward = Vec3(0, -1, 0);
    camera.up = Vec3(0.6f, 0, -0.8f);
    camera.right = cross(camera.forward, camera.up);
    expect_vector("direction of the middle of pixel (6, 1), of a camera that looks down",
                  camera_ray(camera, 6, 1, Vec2(0.5f), Vec2(0)).d,
                  normalize(camera.forward + 0.625f * camera.right + 0.125f * camera.up), 1e-6,
                  "the image lies along camera.right and camera.up, whichever way they point");
}

TEST(Task1_1, AllRaysOfAPointMeetInThePlaneInFocus) {
    Camera camera = pinhole();
    camera.lens_radius = 0.25f;
    camera.focus_distance = 4;
    const Vec3 expected = camera.position + 4.0f * Vec3(0.625f, 0.125f, -1);
    for (int i = 0; i < 64; ++i) {
        const Vec2 u_lens((i % 8 + 0.5f) / 8, (i / 8 + 0.5f) / 8);
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
    }
}

// Uniform on the unit disk:  E[x^2] = E[y^2] = 1/4,  E[x y] = 0,  P(r < 1/2) = 1/4.
TEST(Task1_1, RaysStartUniformlyOnTheLens) {
    Camera camera = pinhole();
    camera.lens_radius = 0.25f;
    camera.focus_distance = 4;
    constexpr int n = 32;
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0, inner = 0;
    for (int i = 0; i < n * n; ++i) {
        const Vec2 u_lens((i % n + 0.5f) / n, (i / n + 0.5f) / n);
        const Ray ray = camera_ray(camera, 6, 1, Vec2(0.7f, 0.4f), u_lens);
        const double a = (ray.o.x - camera.position.x) / 0.25;
        const double b = (ray.o.y - camera.position.y) / 0.25;
        x += a / (n * n), y += b / (n * n), xx += a * a / (n * n), yy += b * b / (n * n);
        xy += a * b / (n * n), inner += (a * a + b * b < 0.25) / double(n * n);
    }
    const std::string numbers = "both coordinates of the point on the lens come from u_lens, from "
                                "both of its numbers";
    const std::string uniform =
        "the point is not uniform on the disk: sample_disk() makes it of u_lens";
    const bool holds = expect_near("of points on a lens, mean x y over mean r^2", xy / (xx + yy), 0,
                                   0.02, numbers) &&
                       expect_near("of points on a lens, mean x^2 over mean r^2", xx / (xx + yy),
                                   0.5, 0.02, numbers);
    if (!holds) return;
    expect_near("of points on a lens of radius 1, mean x", x, 0, 0.02, uniform);
    expect_near("of points on a lens of radius 1, mean y", y, 0, 0.02, uniform);
    expect_near("of points on a lens of radius 1, mean r^2", xx + yy, 0.5, 0.02, uniform);
    expect_near("share of the points within half the radius", inner, 0.25, 0.03, uniform);
}

} // namespace

} // namespace raylab::lab01
