// Task 2.5: Russian roulette, by itself and in the loop of task 2.1.
#include "labs/02_iterative/tests/one_path.h"

namespace raylab::lab02 {

namespace {

using namespace task;

// Whatever the probability of survival is, the mean of the new throughput over u is the old one.
TEST(Task2_5, RouletteLeavesTheMean) {
    constexpr int n = 1 << 14;
    for (const Vec3 throughput :
         {Vec3(0.2f), Vec3(0.5f), Vec3(0.1f, 0.3f, 0.02f), Vec3(0.9f, 0.2f, 0.6f), Vec3(2, 1, 0.5f),
          Vec3(0, 0.1f, 0.3f), Vec3(0.2f, 0, 0.1f), Vec3(0.3f, 0.1f, 0)}) {
        const bool bright = max_component(throughput) > 0.4f;
        const bool dark_channel = std::min({throughput.x, throughput.y, throughput.z}) == 0;
        double sum[3] = {};
        for (int i = 0; i < n; ++i) {
            Vec3 left = throughput;
            if (!survives_roulette(left, 6, (i + 0.5f) / n)) continue;
            for (int c = 0; c < 3; ++c) sum[c] += left[c] / n;
        }
        if (!expect_vector(
                "mean throughput after roulette", Vec3(sum[0], sum[1], sum[2]), throughput,
                2e-3 * max_component(throughput),
                bright && sum[0] > 0 ? "q is at most 1: a bright path always goes on, as it is"
                : dark_channel ? "q follows the largest channel of the throughput: of another it "
                                 "may be 0, where light is left"
                               : "a survivor counts 1 / q, q the probability to survive; a path "
                                 "ends if u >= q"))
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

std::string with_roulette(int depth) {
    return fmt::format(R"("max_depth": {}, "spp": 1, "direct_light": "bsdf", "roulette": true)",
                       depth);
}

// 1 + 1/2 + 1/4 + ... = 2. Every path of 40 surfaces that roulette does not end has this sum.
TEST(Task2_5, ThePathAsksRoulette) {
    const Scene scene = small_scene(
        {R"("a": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5], "emission": [1, 1, 1]})",
         R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})", "",
         with_roulette(40)});
    Samples samples;
    int ended = 0;
    for (int k = 0; k < 4000; ++k) {
        PathRecord record;
        samples.add(trace(scene, {Vec3(0.2f, 0, 0), Vec3(0, 1, 0)}, k, &record).x);
        ended += record.length < 40;
    }
    const bool asked = std::fabs(samples.mean() - 2) > 1e-3 || samples.error() > 1e-3;
    if (expect(ended > 0, fmt::format("none of 4000 paths ends before max_depth 40; the likely "
                                      "cause: {}",
                                      asked ? "a path for which roulette says no must end"
                                            : "trace_path() never calls survives_roulette()")))
        expect_near(fmt::format("mean of a furnace of albedo 0.5 with Russian roulette (standard "
                                "error {:.2g})",
                                samples.error()),
                    samples.mean(), 2, Samples::allowed * samples.error() + 1e-6,
                    "roulette is asked once a surface, for the throughput with this surface's "
                    "weight");
}

// A mirror of reflectance 0.2 sends the path up to glass, where roulette plays (q = 1/2 or
// another). What is refracted sees the sky, what is reflected meets the mirror again: 0.2 (1 - F).
TEST(Task2_5, LobeAndRouletteHaveNumbersOfTheirOwn) {
    const Scene scene = small_scene(
        {R"("dim": {"kind": "mirror", "reflectance": [0.2, 0.2, 0.2]},
            "glass": {"kind": "glass", "ior": 1.5})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "dim"},
            {"kind": "plane", "point": [0, 1, 0], "normal": [0, -1, 0], "material": "glass"})",
         R"({"kind": "environment", "radiance": [1, 1, 1]})", with_roulette(3)});
    Samples samples;
    for (int k = 0; k < 8000; ++k)
        samples.add(trace(scene, {Vec3(0, 0.5f, 0), Vec3(0.96f, -0.28f, 0)}, k).x);
    const double cos_i = 0.28, cos_t = std::sqrt(1 - 0.9216 / 2.25);
    const double parallel = (1.5 * cos_i - cos_t) / (1.5 * cos_i + cos_t);
    const double perpendicular = (cos_i - 1.5 * cos_t) / (cos_i + 1.5 * cos_t);
    const double F = (parallel * parallel + perpendicular * perpendicular) / 2;
    expect_near(
        fmt::format("mean sky through glass that a mirror of reflectance 0.2 shows (standard "
                    "error {:.2g})",
                    samples.error()),
        samples.mean(), 0.2 * (1 - F), Samples::allowed * samples.error() + 1e-6,
        "the number that has chosen the lobe is no number for roulette: u.roulette");
}

} // namespace

} // namespace raylab::lab02
