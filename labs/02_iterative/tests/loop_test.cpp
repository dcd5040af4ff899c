// Tasks 2.1 and 2.5: the loop's throughput and Russian roulette, called without any kernel.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/02_iterative/path.h"
#include "labs/02_iterative/whitted.h"

namespace raylab::lab02 {

namespace {

using namespace task;

constexpr Features tested = feature::sphere | feature::quad | feature::plane | feature::diffuse |
                            feature::mirror | feature::glass | feature::area_light |
                            feature::point_light | feature::environment;

// One sample of the radiance along the ray; sample k has numbers of its own.
Vec3 trace(const Scene& scene, const Ray& ray, std::uint32_t k = 0, PathRecord* result = nullptr) {
    PathRecord record;
    const Sampler sampler = {SamplerKind::independent, 1, 0, k};
    const Vec3 radiance =
        scene.render.integrator == Integrator::path
            ? trace_path<tested>(view(scene), scene.render, sampler, ray, record)
            : trace_whitted<tested>(view(scene), scene.render, sampler, ray, record);
    if (result) *result = record;
    return radiance;
}

std::string settings(int depth, const std::string& strategy) {
    return fmt::format(R"("max_depth": {}, "spp": 1, "direct_light": "{}", "roulette": false)",
                       depth, strategy);
}

std::string whitted(int depth) {
    return fmt::format(R"("integrator": "whitted", "max_depth": {}, "spp": 1)", depth);
}

const std::string white_sky = R"({"kind": "environment", "radiance": [1, 1, 1]})";

// In a closed sphere that glows with e and reflects a, d surfaces give e (1 - a^d) / (1 - a),
// whichever way a path takes.
TEST(Task2_1, AFurnaceIsAGeometricSeries) {
    for (const int depth : {1, 2, 3, 12}) {
        const Scene scene = small_scene(
            {R"("a": {"kind": "diffuse", "reflectance": [0.5, 0.25, 0.75], "emission": [1, 1, 1]})",
             R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})", "",
             settings(depth, "bsdf")});
        PathRecord record;
        const Vec3 radiance = trace(scene, {Vec3(0.2f, 0, 0), Vec3(0, 1, 0)}, 5, &record);
        const auto series = [&](double a) { return float((1 - std::pow(a, depth)) / (1 - a)); };
        if (!expect_vector(
                fmt::format("radiance in a furnace of albedo (0.5, 0.25, 0.75) at max_depth {}",
                            depth),
                radiance, Vec3(series(0.5), series(0.25), series(0.75)), 1e-4,
                depth == 1
                    ? "the first surface's emission is added times a throughput of one"
                    : "throughput *= weight once a surface, and radiance += throughput * Le") ||
            !expect_equal("rays counted", record.length, depth,
                          "the loop turns once for each of max_depth surfaces, and calls "
                          "record_hit() each time"))
            return;
    }
}

TEST(Task2_1, ThePathGoesWhereMirrorsSendIt) {
    const Scene scene = small_scene(
        {R"("half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]},
            "red": {"kind": "mirror", "reflectance": [1, 0.25, 0]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "half"},
            {"kind": "plane", "point": [0, 0, 0], "normal": [1, 0, 0], "material": "red"})",
         R"({"kind": "environment", "radiance": [1, 2, 3]})", settings(8, "mis")});
    expect_vector("sky", trace(scene, {Vec3(2, 1, 0), Vec3(0.6f, 0.8f, 0)}), Vec3(1, 2, 3), 1e-6,
                  "an escaped ray adds throughput * sky, and the path ends");
    PathRecord record;
    expect_vector("sky seen by two mirrors",
                  trace(scene, {Vec3(2, 1, 0), Vec3(-0.6f, -0.8f, 0)}, 0, &record),
                  Vec3(0.5f, 0.25f, 0), 1e-5,
                  "both mirrors dim the throughput, and no light sample could have found their "
                  "directions: bsdf_pdf is delta_pdf again");
    expect_equal("rays counted", record.length, 3, "the ray must advance: ray = spawn_ray(...)");
}

// A square lamp of side 2 at height 1, seen from under its middle: radiance = albedo Le F with
//     F = 4 (A / sqrt(1 + A^2) atan(B / sqrt(1 + A^2)) + ...) / 2 pi,  A = B = 1.
// A mirror before it dims it, and counts as a surface.
TEST(Task2_1, AllStrategiesAgreeOnTheLightOfALamp) {
    const double form_factor = 4 * 2 * std::sqrt(0.5) * std::atan(std::sqrt(0.5)) / (2 * M_PI);
    for (const std::string strategy : {"bsdf", "light", "mis"}) {
        const Scene scene = small_scene(
            {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
                "half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]},
                "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"},
                {"kind": "plane", "point": [0, 4, 0], "normal": [0, 1, 0], "material": "half"},
                {"kind": "quad", "material": "lamp",
                 "vertices": [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]]})",
             "", settings(2, strategy)});
        Samples samples;
        for (int k = 0; k < 4000; ++k)
            samples.add(trace(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}, k).x);
        expect_near(fmt::format("mean under a lamp with direct light by \"{}\" (standard error "
                                "{:.2g})",
                                strategy, samples.error()),
                    samples.mean(), 0.5 * 3 * form_factor,
                    Samples::allowed * samples.error() + 1e-6,
                    "light counted twice or not at all: keep bsdf_pdf, the density of the ray's "
                    "direction, for the next turn's emitted_light()");
    }
}

TEST(Task2_1, WhittedsRaysAreATree) {
    const Scene mirrors = small_scene(
        {R"("a": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5], "emission": [1, 1, 1]})",
         R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})", "",
         whitted(5)});
    expect_near("radiance in a glowing mirror sphere at max_depth 5",
                trace(mirrors, {Vec3(0), Vec3(0, 0, 1)}).x, 1.9375, 1e-5,
                "each surface adds throughput * emission, and max_depth counts surfaces");

    // Clear glass under an even sky is invisible; two rays leave each of its surfaces.
    const Scene glass =
        small_scene({R"("glass": {"kind": "glass", "ior": 1.5})",
                     R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "glass"})",
                     white_sky, whitted(14)});
    PathRecord record;
    const Vec3 radiance = trace(glass, {Vec3(0.5f, 0, 3), Vec3(0, 0, -1)}, 0, &record);
    expect_near("even sky of radiance 1 through a glass sphere", radiance.x, 1, 1e-3,
                "both rays go on the stack, each with throughput * its weight");
    // Inside, 13 surfaces in a row send one ray out each; the camera's ray makes one more outside.
    expect_equal("rays of the tree at max_depth 14", record.length, 27,
                 "a ray of depth + 1 == max_depth sends no others, and record_hit() counts each");
}

TEST(Task2_1, WhittedsShadowRaysReachEveryLight) {
    const Scene scene = small_scene(
        {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"})",
         R"({"kind": "point", "position": [0, 2, 0], "intensity": [10, 10, 10]},
            {"kind": "point", "position": [0, 1, 0], "intensity": [3, 3, 3]})",
         whitted(4)});
    expect_near("radiance of a floor under two lights",
                trace(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}).x, 0.5 / M_PI * (10 / 4.0 + 3),
                1e-4, "a diffuse surface adds throughput * the shadow rays to all lights");
}

// Whatever the probability of survival is, the mean of the new throughput over u is the old one.
TEST(Task2_5, RouletteLeavesTheMean) {
    constexpr int n = 1 << 14;
    for (const Vec3 throughput :
         {Vec3(0.5f), Vec3(0.1f, 0.3f, 0.02f), Vec3(0.9f, 0.2f, 0.6f), Vec3(2, 1, 0.5f)}) {
        double sum[3] = {};
        for (int i = 0; i < n; ++i) {
            Vec3 left = throughput;
            if (!survives_roulette(left, 6, (i + 0.5f) / n)) continue;
            for (int c = 0; c < 3; ++c) sum[c] += left[c] / n;
        }
        if (!expect_vector("mean throughput after roulette", Vec3(sum[0], sum[1], sum[2]),
                           throughput, 2e-3 * max_component(throughput),
                           "a survivor counts 1 / q, q the probability to survive; a path ends if "
                           "u >= q"))
            return;
    }
}

TEST(Task2_5, DimPathsEnd) {
    constexpr int n = 1000;
    int ended = 0;
    for (int i = 0; i < n; ++i) {
        Vec3 throughput(0.05f);
        ended += !survives_roulette(throughput, 10, (i + 0.5f) / n);
    }
    expect(ended >= n / 10,
           fmt::format("of 1000 paths with throughput 0.05 at the eleventh surface {} end; the "
                       "likely cause: roulette never says no",
                       ended));
}

TEST(Task2_5, ABlackPathLeavesNoNaN) {
    Vec3 throughput(0);
    const bool goes_on = survives_roulette(throughput, 6, 0);
    expect(!goes_on || is_finite(throughput),
           "a throughput of 0 becomes NaN; the likely cause: division by q = 0, where u >= q must "
           "have ended the path");
}

} // namespace

} // namespace raylab::lab02
