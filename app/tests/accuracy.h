// What the labs' accuracy tests share: scenes written in the test, renders, means with their
// errors, and the table of figures.
//
// Each test is a row of the suite of hard cases, run for every lab. Its truth is a closed form, a
// quadrature in double or an independent tracer inside the test; a second scene or variant with the
// error that the row is for must miss the tolerance. Statistical rows allow four standard errors, a
// false alarm in 16,000 (two-sided); seeds are fixed, so a verdict never changes from run to run.
// Row names are those of the suite; RAYLAB_LONG=1 in the environment asks for full counts.
#pragma once

#include "app/labs.h"
#include "common/geometry/make_quad.h"
#include "common/load/load.h"
#include "common/render/render.h"
#include "common/sampling/tests/statistics.h"
#include "common/scene/quad_groups.h"
#include "common/scene/sphere_groups.h"
#include "common/trace/intersect.h"
#include "labs/01_recursive/intersect.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <optional>

namespace raylab::app {

using test::count;

// In a build that fuses multiplies and adds, two copies of one function may round differently: bits
// and paths are promised in the reference build alone.
#if defined(RAYLAB_FUSED)
constexpr bool fused = true;
#else
constexpr bool fused = false;
#endif

class EachLab : public testing::TestWithParam<std::string> {};

inline std::vector<std::string> lab_numbers() {
    std::vector<std::string> numbers;
    for (const Lab& lab : labs()) numbers.push_back(lab.number);
    return numbers;
}

inline std::string lab_name(const testing::TestParamInfo<std::string>& info) {
    return "Lab" + info.param;
}

// --- Scenes -----------------------------------------------------------------------------------

inline std::string text(DVec3 v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

inline std::string camera(DVec3 position, DVec3 look_at, double vfov_deg,
                          const std::string& more = "") {
    const DVec3 d = look_at - position;
    const DVec3 up = std::fabs(d.y) < 0.9 * glm::length(d) ? DVec3(0, 1, 0) : DVec3(0, 0, 1);
    return fmt::format(R"("position": {}, "look_at": {}, "up": {}, "vfov_deg": {}{})",
                       text(position), text(look_at), text(up), vfov_deg, more);
}

inline std::string sphere(DVec3 center, double radius, const std::string& material) {
    return fmt::format(R"({{"kind": "sphere", "center": {}, "radius": {}, "material": "{}"}})",
                       text(center), radius, material);
}

inline std::string plane(DVec3 point, DVec3 normal, const std::string& material) {
    return fmt::format(R"({{"kind": "plane", "point": {}, "normal": {}, "material": "{}"}})",
                       text(point), text(normal), material);
}

inline std::string quad(DVec3 a, DVec3 b, DVec3 c, DVec3 d, const std::string& material) {
    return fmt::format(R"({{"kind": "quad", "vertices": [{}, {}, {}, {}], "material": "{}"}})",
                       text(a), text(b), text(c), text(d), material);
}

inline std::string triangle(DVec3 a, DVec3 b, DVec3 c, const std::string& material) {
    return fmt::format(R"({{"kind": "triangle", "vertices": [{}, {}, {}], "material": "{}"}})",
                       text(a), text(b), text(c), material);
}

// more: a transform, beginning with a comma.
inline std::string box(DVec3 low, DVec3 high, const std::string& material,
                       const std::string& more = "") {
    return fmt::format(R"({{"kind": "box", "low": {}, "high": {}, "material": "{}"{}}})", text(low),
                       text(high), material, more);
}

inline std::string diffuse(DVec3 albedo, DVec3 emission = DVec3(0)) {
    return fmt::format(R"({{"kind": "diffuse", "reflectance": {}, "emission": {}}})", text(albedo),
                       text(emission));
}

constexpr const char* white_sky = R"({"kind": "environment", "radiance": [1, 1, 1]})";

// The members of a scene file that a test cares about. render: the members of its `render` object,
// beginning with max_depth.
struct SceneText {
    std::string camera, materials, shapes, lights = "", render = R"("max_depth": 2)";
    int width = 8, height = 8;
};

// where: the scene's own name, for the files it names.
inline Scene parse(const SceneText& t, const std::filesystem::path& where = "test.json") {
    return parse_scene(
        fmt::format(
            R"({{"version": 1, "title": "a test", "reason": "a test", "camera": {{{}}},
                "film": {{"width": {}, "height": {}}}, "render": {{{}}}, "materials": {{{}}},
                "shapes": [{}], "lights": [{}]}})",
            t.camera, t.width, t.height, t.render, t.materials, t.shapes, t.lights),
        where);
}

// --- Renders ----------------------------------------------------------------------------------

struct Traced {
    Film film;
    Ledger ledger;
    std::vector<PathRecord> records; // iteration after iteration, pixel by pixel
};

inline Traced trace(const std::string& lab, const Scene& scene, int spp) {
    const std::unique_ptr<Renderer> renderer = find_lab(lab).make(scene, {});
    Traced traced;
    add_samples(*renderer, spp, [&](int) {
        const std::vector<PathRecord> records = renderer->records();
        traced.records.insert(traced.records.end(), records.begin(), records.end());
    });
    traced.film = renderer->film();
    traced.ledger = develop(*renderer, scene).ledger;
    return traced;
}

inline int paths_that(const Traced& traced, PathEnd end) {
    return static_cast<int>(std::count_if(traced.records.begin(), traced.records.end(),
                                          [&](const PathRecord& r) { return r.end == end; }));
}

inline double pixel_mean(const FilmPixel& pixel, int channel = 0) {
    return pixel.sum[channel] / pixel.samples;
}

// The largest relative distance of a pixel's mean from the truth.
inline double worst_pixel(const Film& film, double truth, int channel = 0) {
    double worst = 0;
    for (const FilmPixel& pixel : film.pixels)
        worst = std::max(worst, std::fabs(pixel_mean(pixel, channel) / truth - 1));
    return worst;
}

struct Estimate {
    double mean, error; // error: one standard error of the mean
    double deviation;   // of one sample from its pixel's mean, root mean square
};

// The mean of the film. Right for independent samples: the sampler must be "independent".
inline Estimate estimate(const Film& film, int channel = 0) {
    double sum = 0, variance = 0, spread = 0;
    for (const FilmPixel& pixel : film.pixels) {
        const double n = pixel.samples, mean = pixel.sum[channel] / n;
        const double v = std::max(0.0, pixel.sum_squares[channel] / n - mean * mean) * n / (n - 1);
        sum += mean;
        variance += v / n;
        spread += v;
    }
    const double pixels = static_cast<double>(film.pixels.size());
    return {sum / pixels, std::sqrt(variance) / pixels, std::sqrt(spread / pixels)};
}

// The share of pixels whose sums differ in any bit.
inline double differing_pixels(const Film& a, const Film& b) {
    std::size_t differ = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        differ += std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(FilmPixel)) != 0;
    return static_cast<double>(differ) / static_cast<double>(a.pixels.size());
}

// The closest hit as the lab finds it: lab 01 has intersection code of its own, the others
// common's.
inline Hit closest(const std::string& lab, const SceneView& scene, const Ray& ray) {
    return lab == "01" ? lab01::closest_hit(scene, ray) : intersect<feature::all>(scene, ray);
}

// --- Figures ----------------------------------------------------------------------------------

// One row of the table: ours must be within the tolerance, and the naive variant or the planted
// error beyond it: else the row guards nothing.
inline void figure(const char* row, const std::string& lab, const std::string& what, double ours,
                   double tolerance, std::optional<double> naive = {}) {
    fmt::print("  {:<15} lab {}  {:<52} {:<9.3g} <= {:<9.3g} {}\n", row, lab, what, ours, tolerance,
               naive ? fmt::format("naive {:.3g}", *naive) : "");
    EXPECT_LE(ours, tolerance) << row << ", lab " << lab << ": " << what;
    if (naive) {
        EXPECT_GT(*naive, tolerance)
            << row << ", lab " << lab << ": the naive variant passes: " << what;
    }
}

// A figure that is only reported.
inline void note(const char* row, const std::string& lab, const std::string& what, double ours) {
    fmt::print("  {:<15} lab {}  {:<52} {:.6g}\n", row, lab, what, ours);
}

} // namespace raylab::app
