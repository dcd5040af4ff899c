// SMOOTH-LEAK, SMOOTH-FURNACE, SMOOTH-MIS: interpolated normals change how a face looks, but let no
// light through an opaque one and lose none.
#include "app/tests/accuracy.h"
#include "app/tests/icosphere.h"
#include "common/math/frame.h"

namespace raylab::app {

namespace {

// The bundled meshes, by their names.
const std::filesystem::path bundled = find_scene("cornell").parent_path() / "test.json";

std::string mesh(const std::string& file, const std::string& material, bool smooth = true) {
    return fmt::format(R"({{"kind": "mesh", "file": "meshes/{}", "smooth": {}, "material": "{}"}})",
                       file, smooth, material);
}

std::string path_tracing(const std::string& strategy, int depth = 12) {
    return fmt::format(
        R"("max_depth": {}, "direct_light": "{}", "sampler": "independent", "roulette": false)",
        depth, strategy);
}

// Turns the normals at all corners up to `degrees` away from where they point, each another way.
void tilt_normals(Scene& scene, double degrees) {
    test::Random random(47);
    for (TriangleCorners& at : scene.corners)
        for (Vec3& n : at.normal) {
            const Frame around = Frame::around(n);
            const float a = static_cast<float>(glm::radians(degrees)) * random.u();
            const float turn = two_pi * random.u();
            n = around.to_world(
                Vec3(std::sin(a) * std::cos(turn), std::sin(a) * std::sin(turn), std::cos(a)));
        }
}

// --- SMOOTH-LEAK ------------------------------------------------------------------------------

long long lit_pixels(const Film& film) {
    return std::count_if(film.pixels.begin(), film.pixels.end(),
                         [](const FilmPixel& pixel) { return pixel.sum[0] != 0; });
}

const std::vector<std::pair<std::string, std::string>> opaque = {
    {"diffuse", diffuse(DVec3(0.8))},
    {"mirror", R"({"kind": "mirror", "reflectance": [1, 1, 1]})"},
    {"phong", R"({"kind": "phong", "reflectance": [0.4, 0.4, 0.4], "specular": [0.5, 0.5, 0.5],
                  "exponent": 10})"},
    {"metal", R"({"kind": "conductor", "eta": [1, 1, 1], "k": [3, 3, 3], "alpha": 0.4})"}};

// A lamp behind a wall whose shading normals lean 64 degrees to the side. The camera is in front of
// the wall, but on the back side of the shading normals.
TEST_P(EachLab, SmoothLeakALampBehindAWallStaysBehindIt) {
    for (const auto& [name, material] : opaque)
        for (const char* strategy : {"light", "bsdf", "mis"}) {
            Scene scene = parse(
                {.camera = camera({-4, 0, 1}, {0, 0, 0}, 10),
                 .materials =
                     R"("wall": )" + material + R"(, "lamp": )" + diffuse(DVec3(0), DVec3(1)),
                 .shapes = triangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, "wall") + ", " +
                           quad({-1, -1, -0.5}, {1, -1, -0.5}, {1, 1, -0.5}, {-1, 1, -0.5}, "lamp"),
                 .render = path_tracing(strategy, 3),
                 .width = 16,
                 .height = 4});
            const Vec3 n(0.9f, 0, 0.436f);
            scene.triangles[0].corners = 0;
            scene.corners.push_back({{n, n, n}, {}});
            figure(
                "SMOOTH-LEAK", GetParam(), fmt::format("wall, {}, {}: lit pixels", name, strategy),
                static_cast<double>(lit_pixels(trace(GetParam(), scene, count(16, 400)).film)), 0);
        }
}

// A lamp sealed in an opaque mesh lights nothing, by paths nor by Whitted's rules.
TEST_P(EachLab, SmoothLeakALampInAClosedMeshStaysInIt) {
    for (const auto& [name, material] : opaque)
        for (const std::string shape : {"pawn", "icosphere", "icosphere, tilted"})
            for (const char* integrator : {"path", "whitted"}) {
                Scene scene =
                    parse({.camera = camera({1, 2, 3}, {0, 0.5, 0}, 30),
                           .materials = R"("m": )" + material + R"(, "lamp": )" +
                                        diffuse(DVec3(0), DVec3(1)),
                           .shapes = sphere({0, 0.4, 0}, 0.05, "lamp") +
                                     (shape == "pawn" ? ", " + mesh("pawn.gltf", "m") : ""),
                           .render = path_tracing("mis", 5) +
                                     fmt::format(R"(, "integrator": "{}")", integrator),
                           .width = 64,
                           .height = 64},
                          bundled);
                if (shape != "pawn") add_icosphere(scene, 1, 0.8, 0, true);
                if (shape == "icosphere, tilted") tilt_normals(scene, 85);
                figure(
                    "SMOOTH-LEAK", GetParam(),
                    fmt::format("lamp in {}, {}, {}: lit pixels", shape, name, integrator),
                    static_cast<double>(lit_pixels(trace(GetParam(), scene, count(4, 100)).film)),
                    0);
            }
}

// --- SMOOTH-FURNACE ---------------------------------------------------------------------------

// Under even light a mesh that reflects everything looks as bright as the light, and so does its
// smooth version. For materials that lose some light, the flat mesh is the truth. With tilted
// normals rough glass is left out: its loss depends much on the angle, which the tilt changes.
TEST_P(EachLab, SmoothFurnaceLosesNoEnergy) {
    const std::vector<std::pair<std::string, std::string>> materials = {
        {"diffuse", diffuse(DVec3(1))},
        {"mirror", R"({"kind": "mirror", "reflectance": [1, 1, 1]})"},
        {"glass", R"({"kind": "glass", "ior": 1.5})"},
        {"metal", R"({"kind": "conductor", "eta": [1, 1, 1], "k": [9, 9, 9], "alpha": 0.3})"},
        {"rough glass", R"({"kind": "rough_dielectric", "ior": 1.5, "alpha": 0.2})"}};
    for (const auto& [name, material] : materials)
        for (const std::string shape : {"pawn", "vase", "icosphere", "icosphere, tilted"}) {
            if (name == "rough glass" && shape == "icosphere, tilted") continue;
            const auto furnace = [&](bool smooth) {
                const bool is_pawn = shape == "pawn", is_vase = shape == "vase";
                Scene scene =
                    parse({.camera = camera(is_vase ? DVec3(1, 3, 4) : DVec3(0.6, 1.5, 2.4),
                                            is_vase ? DVec3(0, 1, 0) : DVec3(0, 0.5, 0), 26),
                           .materials = R"("m": )" + material,
                           .shapes = is_pawn || is_vase
                                         ? mesh(is_pawn ? "pawn.gltf" : "vase.obj", "m", smooth)
                                         : "",
                           .lights = white_sky,
                           .render = path_tracing("bsdf", 100),
                           .width = 24,
                           .height = 24},
                          bundled);
                if (!is_pawn && !is_vase) add_icosphere(scene, 1, 0.6, 0, smooth);
                if (shape == "icosphere, tilted") tilt_normals(scene, 60);
                return estimate(trace(GetParam(), scene, count(16, 400)).film);
            };
            const Estimate smooth = furnace(true), flat = furnace(false);
            figure("SMOOTH-FURNACE", GetParam(), fmt::format("{}, {}: from flat", shape, name),
                   std::fabs(smooth.mean - flat.mean), 0.01);
            note("SMOOTH-FURNACE", GetParam(), fmt::format("{}, {}: smooth", shape, name),
                 smooth.mean);
        }
}

// --- SMOOTH-MIS -------------------------------------------------------------------------------

// Finding a lamp by its light, by chance and by both gives one mean (4 standard errors): sampling,
// density and value of the folded BSDF fit together.
TEST_P(EachLab, SmoothMisStrategiesAgree) {
    for (const auto& [name, material] : opaque) {
        if (name == "mirror") continue;
        std::vector<Estimate> found;
        for (const char* strategy : {"light", "bsdf", "mis"}) {
            Scene scene = parse(
                {.camera = camera({1, 2, 3}, {0, 0, 0}, 25),
                 .materials = R"("m": )" + material + R"(, "lamp": )" + diffuse(DVec3(0), DVec3(1)),
                 .shapes = quad({-4, 2, -4}, {-4, 2, 4}, {4, 2, 4}, {4, 2, -4}, "lamp"),
                 .render = path_tracing(strategy, 4),
                 .width = 32,
                 .height = 32});
            add_icosphere(scene, 1, 0.8, 0, true);
            tilt_normals(scene, 60);
            found.push_back(estimate(trace(GetParam(), scene, count(64, 1000)).film));
        }
        for (int i = 1; i < 3; ++i)
            figure("SMOOTH-MIS", GetParam(),
                   fmt::format("{}: light - {}", name, i == 1 ? "bsdf" : "mis"),
                   std::fabs(found[0].mean - found[i].mean),
                   4 * std::hypot(found[0].error, found[i].error));
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
