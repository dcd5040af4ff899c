// Task 1.5: cosine-weighted directions and the recursive estimator, held against closed forms.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "common/transport/emission.h"
#include "labs/01_recursive/cosine.h"
#include "labs/01_recursive/tracer.h"

namespace raylab::lab01 {

namespace {

using namespace task;

// With density cos / pi:  E[z] = 2/3,  E[x^2] = 1/4,  E[x y] = 0,  P(z > 1/2) = 3/4.
TEST(Task1_5, DirectionsThinOutAsTheCosine) {
    constexpr int n = 128;
    double z = 0, x = 0, y = 0, x2 = 0, xy = 0, upper = 0;
    for (int i = 0; i < n * n; ++i) {
        const int column = i % n, row = i / n;
        const Vec3 w = sample_cosine(Vec2((column + 0.5f) / n, (row + 0.5f) / n));
        if (!expect_near("length of a direction", length(w), 1, 1e-5,
                         "the point of the disk is lifted by sqrt(1 - r^2)") ||
            !expect(w.z >= 0, "a direction points below the surface; the likely cause: z is "
                              "the positive root"))
            return;
        x += w.x, y += w.y, z += w.z, x2 += w.x * w.x, xy += w.x * w.y, upper += w.z > 0.5f;
    }
    const double all = n * n;
    const std::string lean = "directions lean to one side: the angle goes all round, 2 pi";
    if (!expect_near("mean x", x / all, 0, 0.01, lean) ||
        !expect_near("mean y", y / all, 0, 0.01, lean) ||
        !expect_near("mean x y", xy / all, 0, 0.01,
                     "both numbers of u are needed: with one alone the disk is a line"))
        return;
    const std::string cause = "points uniform on the disk are lifted straight up; a uniform "
                              "hemisphere has mean z = 1/2";
    expect_near("mean z of directions with density cos / pi", z / all, 2.0 / 3, 0.01, cause);
    expect_near("mean x^2", x2 / all, 0.25, 0.01, cause);
    expect_near("share of directions with z > 1/2", upper / all, 0.75, 0.03, cause);
}

// At the rim of the disk, where r^2 may round to more than 1.
TEST(Task1_5, DirectionsAtTheRimAreNumbers) {
    int bad = 0;
    for (int i = 0; i < 4096; ++i)
        for (const float end : {0.0f, one_minus_epsilon})
            for (const Vec2 u : {Vec2(end, i / 4096.0f), Vec2(i / 4096.0f, end)})
                bad += !(sample_cosine(u).z >= 0);
    expect_equal("of 16384 directions at the rim those whose z is no number", bad, 0,
                 "1 - r^2 rounds to less than 0: the root of a negative number");
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

std::string floor_under(const std::string& light) {
    return R"({"kind": "plane", "point": [0.3, 0.7, -0.2], "normal": [0.36, 0.8, 0.48],
               "material": "floor"})" +
           light;
}

// From outside to a tilted floor through (0.3, 0.7, -0.2), whose points are off it by rounding.
Ray to_tilted_floor(int i) {
    const Vec3 n = normalize(Vec3(0.36f, 0.8f, 0.48f));
    const Vec3 aside(0.013f * i - 0.4f, 0.4f - 0.007f * i, 0.011f * i - 0.3f);
    return {Vec3(0.3f, 0.7f, -0.2f) + 3.0f * n, normalize(aside - 3.0f * n)};
}

TEST(Task1_5, PathsLeaveAFloorUpwards) {
    const std::string grey = R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})";
    const Scene below_a_lamp = small_scene(
        {grey + R"(, "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         floor_under(
             R"(, {"kind": "quad", "material": "lamp", "vertices": [[-64.434, 3.059, 54.836], [44.997, -46.185, 54.836],
                           [68.634, 6.341, -50.436], [-40.797, 55.585, -50.436]]})"),
         "", settings(2, "bsdf")});
    int lost = 0;
    for (int i = 0; i < 64; ++i) {
        PathRecord record;
        trace(below_a_lamp, to_tilted_floor(i), i, &record);
        lost += record.end == PathEnd::escaped;
    }
    if (!expect(lost < 64, "of 64 paths from a floor below a large lamp all escape; the likely "
                           "cause: wo is -ray.d, the way back, and light is scattered on its side"))
        return;
    const Scene below_the_sky =
        small_scene({grey, floor_under(""), R"({"kind": "environment", "radiance": [1, 1, 1]})",
                     settings(6, "bsdf")});
    int once = 0, escaped = 0;
    for (int i = 0; i < 64; ++i) {
        PathRecord record;
        trace(below_the_sky, to_tilted_floor(i), i, &record);
        once += record.length == 2, escaped += record.end == PathEnd::escaped;
    }
    if (expect_equal("of 64 paths from a floor to the sky those of two rays", once, 64,
                     "the next ray meets its own surface again: spawn_ray() starts it off the "
                     "surface"))
        expect_equal("of 64 paths that escape those that say so", escaped, 64,
                     "record.end is set before each way out");
}

// A lobe about the mirrored direction, half of it below the floor at grazing angles.
TEST(Task1_5, ASampleThatIsNotValidEndsThePath) {
    const Scene scene = small_scene(
        {R"("gloss": {"kind": "phong", "reflectance": [0, 0, 0], "specular": [1, 1, 1],
                      "exponent": 2})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "gloss"})",
         R"({"kind": "environment", "radiance": [1, 1, 1]})", settings(4, "bsdf")});
    int ended = 0;
    for (int k = 0; k < 200; ++k) {
        PathRecord record;
        const Vec3 radiance = trace(scene, {Vec3(0, 0.1f, 0), normalize(Vec3(1, -0.1f, 0))},
                                    std::uint32_t(k), &record);
        if (!expect(is_finite(radiance), "radiance of a glossy floor is not finite; the likely "
                                         "cause: a sample that is not valid is followed"))
            return;
        ended += record.length == 1 && record.end == PathEnd::absorbed;
    }
    expect(ended > 40, fmt::format("of 200 paths that graze a glossy floor {} end there, absorbed, "
                                   "where nearly half should; the likely cause: a sample that is "
                                   "not valid is followed",
                                   ended));
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
                           depth == 1 ? "max_depth counts surfaces, and the last only emits"
                                      : "every surface adds Le + weight * L(next), and the weight "
                                        "has the cosine already") ||
            !expect_equal("rays counted", record.length, depth,
                          "record_hit() is called once a ray"))
            return;
    }
}

// A cosine-weighted direction from a point of a sphere leads to a point that is uniform on it, and
// the next from there is an isotropic chord, which crosses a flat lamp of area A inside with
// probability A / (2 pi) (Crofton's formula, radius 1). The first surface lies in the lamp's plane
// and sees it edge on.
TEST(Task1_5, EachBounceHasNumbersOfItsOwn) {
    const Scene scene =
        small_scene({R"("white": {"kind": "diffuse", "reflectance": [1, 1, 1]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [1, 1, 1]})",
                     R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white"},
            {"kind": "quad", "material": "lamp", "vertices":
             [[-0.7, 0, 0.15], [0.5, 0, 0.15], [0.5, 0, 0.65], [-0.7, 0, 0.65]]})",
                     "", settings(3, "bsdf")});
    expect_mean("mean light of a flat lamp of area 0.6 in a white sphere, after two bounces",
                trace_many(scene, {Vec3(0.2f, 0, 0.1f), Vec3(1, 0, 0)}, 8000), 0.6 / (2 * M_PI),
                "each bounce has numbers of its own: bounce_dimension(bounce, ...)");
}

// 1 + 1/2 + 1/4 + ... = 2. Every path of 40 surfaces that roulette does not end has this sum.
TEST(Task1_5, RouletteLeavesTheMean) {
    const Scene scene = furnace(settings(40, "bsdf", true));
    Samples samples;
    int ended = 0;
    for (int k = 0; k < 4000; ++k) {
        PathRecord record;
        samples.add(trace(scene, {Vec3(0.2f, 0, 0), Vec3(0, 1, 0)}, std::uint32_t(k), &record).x);
        ended += record.length < 40;
    }
    const bool plain = std::fabs(samples.mean() - 2) < 1e-3;
    expect_mean("mean of a furnace of albedo 0.5 with Russian roulette", samples, 2,
                ended == 0 ? "a path for which roulette says no must end"
                           : "a path that survives with probability q counts 1 / q");
    expect(ended > 0 || !plain, "none of 4000 paths ends before max_depth 40; the likely cause: "
                                "roulette is never played, though the scene has it on");
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

// What a mean of `share` times the light means.
std::string light_share_cause(double share) {
    return share < 0.5 ? "light that counts not at all: add direct_light(), and what "
                         "emitted_light() and escaped_light() give for bsdf_pdf"
                       : "light counted twice: hand the direction's density on, so that "
                         "emitted_light() and escaped_light() can weigh what a path finds by "
                         "itself";
}

// Light that a shadow ray finds at surface 1 lies on surface 2.
TEST(Task1_5, TheLastSurfaceOnlyEmits) {
    const Scene scene = small_scene(
        {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"})",
         R"({"kind": "point", "position": [0, 2, 0], "intensity": [10, 10, 10]})",
         settings(1, "mis")});
    expect_near("radiance of a floor under a light at max_depth 1",
                trace(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}).x, 0, 0,
                "the last surface only emits: what a shadow ray finds lies on one surface more");
}

// A floor of albedo 1/2 under an even sky of radiance 1 reflects 1/2.
TEST(Task1_5, AllStrategiesAgreeOnTheLightOfTheSky) {
    for (const std::string strategy : {"bsdf", "light", "mis"}) {
        const Scene scene = small_scene(
            {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"})",
             R"({"kind": "environment", "radiance": [1, 1, 1]})", settings(2, strategy)});
        const Samples samples = trace_many(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}, 4000);
        expect_mean(fmt::format("mean under the sky with direct light by \"{}\"", strategy),
                    samples, 0.5, light_share_cause(samples.mean() / 0.5));
    }
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
                    light_share_cause(samples.mean() / (0.5 * 3 * form_factor)));
    }
}

} // namespace

} // namespace raylab::lab01
