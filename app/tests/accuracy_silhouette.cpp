// DUP-COPLANAR, ORTHO-GRID: surfaces that lie on each other, and edges that lie on pixels' borders.
#include "app/tests/accuracy.h"
#include "app/tests/icosphere.h"

#include <random>

namespace raylab::app {

namespace {

// --- DUP-COPLANAR -----------------------------------------------------------------------------

// Every shape twice or thrice in the same place, in three colours, and overlapping triangles in one
// plane: at equal t the lowest id is seen, whatever comes first in memory.
Scene stacked() {
    std::string shapes;
    const auto add = [&](const std::string& shape) {
        shapes += (shapes.empty() ? "" : ", ") + shape;
    };
    for (const char* m : {"red", "green", "blue"}) {
        add(sphere({-1.2, 0, 0}, 0.7, m));
        add(quad({-2, -1, -1}, {0, -1, -1}, {0, 1, -1}, {-2, 1, -1}, m));
        add(plane({0, -1.5, 0}, {0, 1, 0}, m));
        for (int i = 0; i < 6; ++i) {
            const double x = 0.2 * i;
            add(triangle({x, -1, 0}, {x + 1, -1, 0}, {x, 1, 0}, m));
            add(triangle({x + 1, 1, 0}, {x, 1, 0}, {x + 1, -1, 0}, m));
        }
    }
    return parse({.camera = camera({0.3, 0.2, 5}, {0.1, 0, 0}, 40),
                  .materials = R"("red": )" + diffuse({0.9, 0.1, 0.1}) + R"(, "green": )" +
                               diffuse({0.1, 0.9, 0.1}) + R"(, "blue": )" +
                               diffuse({0.1, 0.1, 0.9}),
                  .shapes = shapes,
                  .lights = white_sky,
                  .render = R"("max_depth": 4)",
                  .width = 48,
                  .height = 48});
}

TEST_P(EachLab, DupCoplanarTheImageDoesNotDependOnTheOrderInMemory) {
    const Scene scene = stacked();
    const Film expected = trace(GetParam(), scene, 4).film;
    std::mt19937 random(51);
    const auto shuffled = [&](int triangles_in_run) {
        Scene s = scene;
        std::shuffle(s.spheres.begin(), s.spheres.end(), random);
        s.sphere_groups = group_spheres(s.spheres);
        std::shuffle(s.quads.begin(), s.quads.end(), random);
        s.quad_groups = group_quads(s.quads);
        std::shuffle(s.planes.begin(), s.planes.end(), random);
        std::shuffle(s.triangles.begin(), s.triangles.end(), random);
        // Boxes around any `triangles_in_run` triangles, whether they lie close together or not.
        s.runs.clear();
        const int n = static_cast<int>(s.triangles.size());
        for (int first = 0; first < n; first += triangles_in_run) {
            TriangleRun run{{}, first, std::min(triangles_in_run, n - first)};
            for (int i = first; i < first + run.count; ++i)
                for (const Vec3& v : s.triangles[i].v) run.bounds.include(v);
            s.runs.push_back(run);
        }
        return s;
    };
    for (const int size : {1, 5, 1000})
        figure("DUP-COPLANAR", GetParam(),
               fmt::format("shuffled, runs of {}: pixels that change", size),
               differing_pixels(trace(GetParam(), shuffled(size), 4).film, expected), 0);
    // The naive rule takes the first hit in memory. Numbering the shuffled shapes anew has the same
    // effect.
    Scene renumbered = shuffled(5);
    int id = 0;
    for (Sphere& s : renumbered.spheres) s.tags.id = id++;
    for (Quad& q : renumbered.quads) q.tags.id = id++;
    for (Plane& p : renumbered.planes) p.tags.id = id++;
    for (Triangle& t : renumbered.triangles) t.tags.id = id++;
    EXPECT_GT(differing_pixels(trace(GetParam(), renumbered, 4).film, expected), 0.1);
}

// --- ORTHO-GRID -------------------------------------------------------------------------------

constexpr int cells = 16;

bool is_bright(int i, int j) { return (i * 7 + j * 13 + i * j) % 3 == 0; }

// A floor of unit cubes, each as wide as one pixel: a pixel must show its own cube and no other.
TEST_P(EachLab, OrthoGridEveryPixelShowsItsOwnCube) {
    std::string shapes;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            shapes += (i + j ? ", " : "") + box({i - cells / 2, j - cells / 2, -1},
                                                {i - cells / 2 + 1, j - cells / 2 + 1, 0},
                                                is_bright(i, j) ? "bright" : "dim");
    Scene scene = parse({.camera = camera({0, 0, 16}, {0, 0, 0}, 50),
                         .materials = R"("bright": )" + diffuse(DVec3(0), DVec3(1)) +
                                      R"(, "dim": )" + diffuse(DVec3(0), DVec3(0.25)),
                         .shapes = shapes,
                         .render = R"("max_depth": 1)",
                         .width = cells,
                         .height = cells});
    const auto wrong = [&](const Film& film) {
        int pixels = 0;
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x)
                pixels += pixel_mean(film.pixels[y * cells + x]) !=
                          (is_bright(x, cells - 1 - y) ? 1 : 0.25);
        return pixels;
    };
    scene.camera.half_width = scene.camera.half_height = 0.5f; // 8 / 16: 16 units at distance 16
    const Film film = trace(GetParam(), scene, count(32, 1024)).film;
    scene.camera.half_width *= 1.001f; // the planted error
    figure("ORTHO-GRID", GetParam(), "wrong pixels of 256", wrong(film), 0,
           wrong(trace(GetParam(), scene, 16).film));
}

// Rays go straight down, with direction components +0 and -0, onto faces, edges and corners of
// cubes with gaps between them. A cube is closed: a ray that touches it must hit its top, whose
// distance is exactly the height of the ray's origin.
TEST_P(EachLab, OrthoGridRaysInFacesMeetTheClosedCubes) {
    std::string shapes;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            if (is_bright(i, j))
                shapes += (shapes.empty() ? "" : ", ") + box({i, j, -1}, {i + 1, j + 1, 0}, "m");
    const Scene scene = parse({.camera = camera({0, 0, 16}, {0, 0, 0}, 50),
                               .materials = R"("m": )" + diffuse(DVec3(0.5)),
                               .shapes = shapes});
    const SceneView v = view(scene);
    int wrong = 0, strict_wrong = 0, rays = 0;
    for (int y2 = -1; y2 <= 2 * cells + 1; ++y2) // twice the coordinates: halves are cells' middles
        for (int x2 = -1; x2 <= 2 * cells + 1; ++x2)
            for (const float zero : {0.0f, -0.0f}) {
                bool touches = false, inside = false;
                for (int j = 0; j < cells; ++j)
                    for (int i = 0; i < cells; ++i) {
                        if (!is_bright(i, j)) continue;
                        touches |= 2 * i <= x2 && x2 <= 2 * i + 2 && 2 * j <= y2 && y2 <= 2 * j + 2;
                        inside |= 2 * i < x2 && x2 < 2 * i + 2 && 2 * j < y2 && y2 < 2 * j + 2;
                    }
                const Hit hit =
                    closest(GetParam(), v, {Vec3(0.5f * x2, 0.5f * y2, 5), Vec3(zero, -zero, -1)});
                wrong += hit.found() != touches || (touches && hit.t != 5);
                strict_wrong += touches != inside;
                ++rays;
            }
    figure("ORTHO-GRID", GetParam(), fmt::format("wrong of {} rays in faces", rays), wrong, 0,
           strict_wrong);
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
