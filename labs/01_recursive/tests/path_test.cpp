// Task 1.5: cosine-weighted directions and the recursive estimator, held against closed forms.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "common/transport/emission.h"
#include "labs/01_recursive/cosine.h"
#include "labs/01_recursive/tracer.h"

namespace raylab::lab01 {

namespace {

using namespace task;

// With density cos / pi:  E[z] = 2/3,  E[x^2] = 1/4,  P(z > 1/2) = 3/4.
TEST(Task1_5, DirectionsThinOutAsTheCosine) {
    constexpr int n = 128;
    double z = 0, x = 0, y = 0, x2 = 0, upper = 0;
    for (int i = 0; i < n * n; ++i) {
        const int column = i % n, row = i / n;
        const Vec3 w = sample_cosine(Vec2((column + 0.5f) / n, (row + 0.5f) / n));
        if (!expect_near("length of a direction", length(w), 1, 1e-5,
                         "the point of the disk is lifted by sqrt(1 - r^2)") ||
            !expect(w.z >= 0, "a direction points below the surface; the likely cause: z is "
                              "the positive root"))
            return;
        x += w.x, y += w.y, z += w.z, x2 += w.x * w.x, upper += w.z > 0.5f;
    }
    const double all = n * n;
    const std::string cause = "points uniform on the disk are lifted straight up; a uniform "
                              "hemisphere has mean z = 1/2";
    expect_near("mean z of directions with density cos / pi", z / all, 2.0 / 3, 0.01, cause);
    expect_near("mean x^2", x2 / all, 0.25, 0.01, cause);
    expect_near("share of directions with z > 1/2", upper / all, 0.75, 0.03, cause);
    expect_near("mean x + mean y", (x + y) / all, 0, 0.01, "directions lean to one side");
}

TEST(Task1_5, ADiffuseSampleWeighsItsAlbedo) {
    const BsdfSample sample = scatter_diffuse(Vec3(0.5f, 0.25f, 1), Vec2(0.3f, 0.8f));
    expect(sample.valid, "a diffuse sample should be valid but is not; the likely cause: `valid` "
                         "is left false");
    expect_vector("weight of a diffuse sample", sample.weight, Vec3(0.5f, 0.25f, 1), 1e-5,
                  "f cos / pdf = (albedo / pi) cos / (cos / pi) = albedo");
    expect_near("density of its direction", sample.pdf, sample.wi.z / M_PI, 1e-6,
                "the density of direction wi is wi.z / pi");
    expect(!sample.specular, "a diffuse sample is not specular: light samples find it too");
}

// One sample of the radiance along the ray; sample k has numbers of its own.
Vec3 trace(const Scene& scene, const Ray& ray, std::uint32_t k = 0, PathRecord* result = nullptr) {
    const SceneView scene_view = view(scene);
    PathRecord record;
    const Path path = {scene_view, scene.render, {SamplerKind::independent, 1, 0, k}, record};
    const Vec3 radiance = trace_path(path, ray, 0, delta_pdf, Vec3(1));
    if (result) *result = record;
    return radiance;
}

Samples trace_many(const Scene& scene, const Ray& ray, int n) {
    Samples samples;
    for (int k = 0; k < n; ++k) samples.add(trace(scene, ray, k).x);
    return samples;
}

void expect_mean(const std::string& what, const Samples& samples, double expected,
                 const std::string& cause) {
    expect_near(fmt::format("{} (standard error {:.2g})", what, samples.error()), samples.mean(),
                expected, Samples::allowed * samples.error() + 1e-6, cause);
}

std::string settings(int depth, const std::string& strategy, bool roulette = false) {
    return fmt::format(R"("max_depth": {}, "spp": 1, "direct_light": "{}", "roulette": {})", depth,
                       strategy, roulette);
}

Scene furnace(const std::string& render) {
    return small_scene({R"("a": {"kind": "diffuse", "reflectance": [0.5, 0.25, 0.75],
                                 "emission": [1, 1, 1]})",
                        R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})",
                        "", render});
}

// In a closed sphere that glows with e and reflects a, d surfaces give e (1 - a^d) / (1 - a),
// whichever way a path takes.
TEST(Task1_5, AFurnaceIsAGeometricSeries) {
    for (const int depth : {1, 2, 3, 12}) {
        PathRecord record;
        const Vec3 radiance =
            trace(furnace(settings(depth, "bsdf")), {Vec3(0.2f, 0, 0), Vec3(0, 1, 0)}, 5, &record);
        const auto series = [&](double a) { return float((1 - std::pow(a, depth)) / (1 - a)); };
        if (!expect_vector(fmt::format("radiance in a furnace of albedo (0.5, 0.25, 0.75) at "
                                       "max_depth {}",
                                       depth),
                           radiance, Vec3(series(0.5), series(0.25), series(0.75)), 1e-4,
                           "Le + weight * L(next), and max_depth counts surfaces") ||
            !expect_equal("rays counted", record.length, depth,
                          "record_hit() is called once a ray"))
            return;
    }
}

TEST(Task1_5, RouletteLeavesTheMean) {
    const Samples samples =
        trace_many(furnace(settings(40, "bsdf", true)), {Vec3(0.2f, 0, 0), Vec3(0, 1, 0)}, 4000);
    expect_mean("mean of a furnace of albedo 0.5 with Russian roulette", samples, 2,
                "a path that survives with probability q counts 1 / q");
}

TEST(Task1_5, SkyAndMirrors) {
    const Scene scene = small_scene(
        {R"("half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "half"})",
         R"({"kind": "environment", "radiance": [1, 2, 3]})", settings(4, "mis")});
    expect_vector("sky", trace(scene, {Vec3(0, 1, 0), Vec3(0, 1, 0)}), Vec3(1, 2, 3), 1e-6,
                  "an escaped ray returns the sky");
    expect_vector("sky in a mirror of reflectance 0.5",
                  trace(scene, {Vec3(0, 1, 0), Vec3(0.6f, -0.8f, 0)}), Vec3(0.5f, 1, 1.5f), 1e-5,
                  "no light sample could have found a mirror's direction: hand on delta_pdf");
}

// Under the middle of a square lamp, as in task 1.3: radiance = albedo Le F, by whichever strategy.
TEST(Task1_5, AllStrategiesAgreeOnTheLightOfALamp) {
    const double form_factor = 4 * 2 * std::sqrt(0.5) * std::atan(std::sqrt(0.5)) / (2 * M_PI);
    for (const std::string strategy : {"bsdf", "light", "mis"}) {
        const Scene scene = small_scene(
            {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
                "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"},
                {"kind": "quad", "material": "lamp",
                 "vertices": [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]]})",
             "", settings(2, strategy)});
        const Samples samples = trace_many(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}, 4000);
        expect_mean(fmt::format("mean under a lamp with direct light by \"{}\"", strategy), samples,
                    0.5 * 3 * form_factor,
                    "light counted twice or not at all: hand the direction's density on, so that "
                    "emitted_light() can weigh what a path finds by itself");
    }
}

} // namespace

} // namespace raylab::lab01
