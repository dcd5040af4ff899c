// What surface_at and reflectance_at say about a hit.
#include "common/geometry/tests/support.h"
#include "common/trace/texture.h"

#include <array>
#include <random>

namespace raylab::test {
namespace {

constexpr Features with_corners =
    all_shapes | feature::corners | feature::texture | feature::vertex_colours;

template <Features F> Vec3 at_uv(const SceneView& scene, const Material& material, Vec2 uv) {
    SurfacePoint surface{};
    surface.uv = uv;
    return reflectance_at<F>(scene, material, surface);
}

void expect_near(Vec3 a, Vec3 b, float tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

SurfacePoint shoot(const SceneView& scene, Vec3 from, Vec3 to) {
    const Ray ray{from, normalize(to - from)};
    const Hit hit = intersect<with_corners>(scene, ray);
    EXPECT_TRUE(hit.found());
    return surface_at<with_corners>(scene, ray, hit);
}

TEST(Surface, sphere_normals_point_outward_from_either_side) {
    World world;
    world.add(Sphere{Vec3(1, 2, 3), 2, {}});
    for (Vec3 from : {Vec3(1, 2, 9), Vec3(1, 2, 4)}) {
        const SurfacePoint p =
            shoot(world.view(), from, from + (from.z > 5 ? -1.0f : 1.0f) * Vec3(0, 0, 1));
        expect_near(p.p, Vec3(1, 2, 5), 1e-6f);
        expect_near(p.ng, Vec3(0, 0, 1), 1e-6f);
        expect_near(p.shading.z, p.ng, 0);
    }
}

TEST(Surface, tags_come_from_the_shape_that_was_hit) {
    World world;
    world.add(Sphere{Vec3(0, 0, -10), 1, {}});
    world.add(make_quad(Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)));
    world.quads[0].tags = {7, 3, 5};
    const SurfacePoint p = shoot(world.view(), Vec3(0, 0, 4), Vec3(0, 0, 0));
    EXPECT_EQ(p.material, 3);
    EXPECT_EQ(p.light, 5);
}

TEST(Surface, quad_coordinates_run_from_corner_0_along_its_sides) {
    World world;
    const Vec3 o(1, 1, 0), e1(4, 1, 0), e2(-1, 2, 0);
    world.add(make_quad(o, o + e1, o + e1 + e2, o + e2));
    for (Vec2 uv : {Vec2(0.25f, 0.75f), Vec2(0.9f, 0.1f), Vec2(0.5f, 0.5f)}) {
        const Vec3 at = o + uv.x * e1 + uv.y * e2;
        const SurfacePoint p = shoot(world.view(), at + Vec3(0, 0, 3), at);
        EXPECT_NEAR(p.uv.x, uv.x, 3e-6);
        EXPECT_NEAR(p.uv.y, uv.y, 3e-6);
        expect_near(p.ng, Vec3(0, 0, 1), 0);
    }
}

TEST(Surface, sphere_coordinates_are_longitude_and_latitude) {
    World world;
    world.add(Sphere{Vec3(0), 1, {}});
    const struct {
        Vec3 from;
        Vec2 uv;
    } cases[] = {{Vec3(5, 0, 0), Vec2(0, 0.5f)},     {Vec3(0, 0, 5), Vec2(0.25f, 0.5f)},
                 {Vec3(-5, 0, 0), Vec2(0.5f, 0.5f)}, {Vec3(0, 0, -5), Vec2(0.75f, 0.5f)},
                 {Vec3(0, 5, 0), Vec2(0, 1)},        {Vec3(0, -5, 0), Vec2(0, 0)}};
    for (const auto& [from, uv] : cases) {
        const SurfacePoint p = shoot(world.view(), from, Vec3(0));
        if (from.y == 0) {
            EXPECT_NEAR(p.uv.x, uv.x, 1e-6);
        }
        EXPECT_NEAR(p.uv.y, uv.y, 1e-6);
    }
}

TEST(Surface, corner_normals_are_interpolated_and_kept_on_the_side_of_the_face) {
    World world;
    world.add(make_triangle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    world.triangles[0].corners = 0;
    world.make_runs(16);
    TriangleCorners corners{{normalize(Vec3(-1, 0, 2)), normalize(Vec3(1, 0, 2)), Vec3(0, 0, 1)},
                            {Vec2(0, 0), Vec2(2, 0), Vec2(0, 4)}};
    SceneView scene = world.view();
    scene.corners = {&corners, 1};
    const Vec3 at(0.5f, 0.25f, 0);
    const Vec3 expected =
        normalize(0.25f * corners.normal[0] + 0.5f * corners.normal[1] + 0.25f * corners.normal[2]);
    SurfacePoint p = shoot(scene, at + Vec3(0, 0, 2), at);
    expect_near(p.shading.z, expected, 2e-6f);
    expect_near(p.ng, Vec3(0, 0, 1), 0);
    EXPECT_NEAR(p.uv.x, 1, 1e-5);
    EXPECT_NEAR(p.uv.y, 1, 1e-5);
    // A file may wind its faces against its normals.
    for (Vec3& n : corners.normal) n = -n;
    p = shoot(scene, at + Vec3(0, 0, 2), at);
    expect_near(p.shading.z, expected, 2e-6f);
    // Normals that cancel leave the face's own.
    corners.normal[0] = corners.normal[1] = corners.normal[2] = Vec3(0);
    p = shoot(scene, at + Vec3(0, 0, 2), at);
    expect_near(p.shading.z, p.ng, 0);
}

// A 3 x 2 image: texel centres, halfway points and the wrap on both axes.
TEST(Texture, is_bilinear_between_texel_centres_and_repeats) {
    const Vec3 texels[] = {Vec3(9), Vec3(0), Vec3(1), Vec3(2), Vec3(10), Vec3(11), Vec3(12)};
    const Texture texture{1, 3, 2}; // the first texel is another image's
    SceneView scene{};
    scene.texels = {texels, 7};
    scene.textures = {&texture, 1};
    Material material;
    material.texture = 0;
    const auto at = [&](double u, double v) {
        return at_uv<feature::all>(scene, material, Vec2(u, v)).x;
    };
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) EXPECT_NEAR(at((x + 0.5) / 3, (y + 0.5) / 2), 10 * y + x, 1e-5);
    EXPECT_NEAR(at(1.0 / 3, 0.25), 0.5, 1e-5);
    EXPECT_NEAR(at(0.5, 0.5), 6, 1e-5);
    EXPECT_NEAR(at(0, 0.25), 1, 1e-5); // between the last column and the first
    EXPECT_NEAR(at(0.5, 0), 6, 1e-5);
    EXPECT_NEAR(at(0.5 + 7, 0.5 - 3), 6, 1e-4);
    EXPECT_NEAR(at(1 - 1e-7, 0.25), 1, 1e-5);
    EXPECT_NEAR(at(-1e-9, -1e-9), at(0, 0), 1e-5);
    // A kernel for scenes without textures does not look.
    EXPECT_EQ(at_uv<0>(scene, material, Vec2(0)), material.reflectance);
}

// A row of 4 texels, 0 to 3, looked at from two images to the left to two to the right.
TEST(Texture, clamps_and_mirrors) {
    const Vec3 texels[] = {Vec3(0), Vec3(1), Vec3(2), Vec3(3)};
    SceneView scene{};
    scene.texels = {texels, 4};
    Material material;
    material.texture = 0;
    const auto expect_row = [&](Wrap wrap, const std::array<float, 20>& centres) {
        const Texture across{0, 4, 1, wrap, Wrap::repeat}, upwards{0, 1, 4, Wrap::repeat, wrap};
        for (int i = 0; i < 20; ++i) { // texel centres, and half way to the next
            const float u = (i - 8 + 0.5f) / 4;
            scene.textures = {&across, 1};
            EXPECT_NEAR(at_uv<feature::all>(scene, material, Vec2(u, 0)).x, centres[i], 1e-5);
            scene.textures = {&upwards, 1};
            EXPECT_NEAR(at_uv<feature::all>(scene, material, Vec2(0, u)).x, centres[i], 1e-5);
            if (i < 19) {
                EXPECT_NEAR(at_uv<feature::all>(scene, material, Vec2(0, u + 0.125f)).x,
                            (centres[i] + centres[i + 1]) / 2, 1e-5)
                    << i;
            }
        }
    };
    expect_row(Wrap::clamp, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3});
    expect_row(Wrap::mirror, {0, 1, 2, 3, 3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0, 0, 1, 2, 3});
}

TEST(SurfaceAt, interpolates_vertex_colours) {
    World world;
    world.add(make_triangle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    world.triangles[0].corners = 0;
    world.make_runs(16);
    const TriangleCorners corners{{Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}, {}, 0};
    const CornerColours colours{{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0.5f)}};
    SceneView scene = world.view();
    scene.corners = {&corners, 1};
    scene.corner_colours = {&colours, 1};
    const SurfacePoint p = shoot(scene, Vec3(0.25f, 0.5f, 3), Vec3(0.25f, 0.5f, 0));
    Material material;
    material.reflectance = Vec3(0.5f);
    const Vec3 reflectance = reflectance_at<feature::all>(scene, material, p);
    EXPECT_NEAR(reflectance.x, 0.125, 1e-6);
    EXPECT_NEAR(reflectance.y, 0.125, 1e-6);
    EXPECT_NEAR(reflectance.z, 0.125, 1e-6);
}

// Coordinates from files may be anything, and interpolation may overflow: whatever they are, a
// texel of this image comes out. What is huge is a whole number, and lies where 0 lies.
TEST(Texture, finds_a_texel_for_every_coordinate) {
    const Vec3 texels[] = {Vec3(-9), Vec3(1), Vec3(2), Vec3(3),
                           Vec3(4),  Vec3(5), Vec3(6), Vec3(-9)};
    SceneView scene{};
    scene.texels = {texels, 8};
    const float nan = std::nanf("");
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
        Texture texture{1, 3, 2};
        texture.wrap_u = texture.wrap_v = wrap;
        for (const float u : {nan, -nan, infinity, -infinity, 1e30f, -1e30f, 3.4e38f, -3.4e38f,
                              0x1p31f, 0x1p-149f, -0x1p-149f, -0.0f})
            for (const float v : {nan, infinity, -1e30f, 0.0f, 0.3f}) {
                const float found = lookup(scene, texture, Vec2(u, v)).x;
                EXPECT_TRUE(found >= 1 && found <= 6) << u << " " << v << ": " << found;
                if (wrap != Wrap::clamp) {
                    EXPECT_EQ(found, lookup(scene, texture, Vec2(0, v)).x) << u << " " << v;
                }
            }
        std::mt19937 random(8); // any float, by its bits
        for (int i = 0; i < 200'000; ++i) {
            const float u = std::bit_cast<float>(std::uint32_t(random()));
            const float v = std::bit_cast<float>(std::uint32_t(random()));
            const float found = lookup(scene, texture, Vec2(u, v)).x;
            ASSERT_TRUE(found >= 1 && found <= 6) << u << " " << v << ": " << found;
        }
    }
}

} // namespace
} // namespace raylab::test
