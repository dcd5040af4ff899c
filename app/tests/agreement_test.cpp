// All labs draw the same image. Every bundled scene, several seeds: the recursive lab and the
// iterative lab trace the same paths, hit for hit, and agree in value to rounding; the iterative
// lab gives the same bits however its threads are cut into blocks, ordered and shared out; so does
// the wavefront, whatever its pool, and the lab with trees, whatever the tree.
#include "app/tests/agreement.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace raylab::app {

namespace {

class EveryScene : public testing::TestWithParam<std::string> {};

TEST_P(EveryScene, RecursiveAndIterativeTraceTheSamePaths) {
    const int side = std::getenv("RAYLAB_LONG") ? 128 : 40;
    for (const std::uint32_t seed : {1u, 20121105u}) {
        const Scene scene = small(GetParam(), side, seed);
        const Traced one = trace("01", scene, {}, 3), two = trace("02", scene, {}, 3);
        ASSERT_EQ(first_difference(one, two, scene.camera.width), "") << "seed " << seed;
        for (std::size_t i = 0; i < one.film.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const double a = one.film.pixels[i].sum[c], b = two.film.pixels[i].sum[c];
                ASSERT_LE(std::fabs(a - b), 1e-5 * std::fabs(a))
                    << "seed " << seed << ", pixel " << i << ", channel " << c << ": " << a
                    << " and " << b;
            }
    }
}

TEST_P(EveryScene, IterativeLabIsBitIdenticalHoweverItIsRun) {
    const Scene scene = small(GetParam(), 24, 7);
    const Film expected = trace("02", scene, {.threads = 1}, 2).film;
    for (const MachineSettings& machine :
         {MachineSettings{.threads = 2, .block_size = 32},
          MachineSettings{.threads = 3, .block_size = 100, .order = ThreadOrder::reverse},
          MachineSettings{
              .threads = 2, .block_size = 1, .order = ThreadOrder::random, .order_seed = 5},
          MachineSettings{.threads = 2, .block_size = 1024, .order = ThreadOrder::random}})
        EXPECT_TRUE(same_bits(trace("02", scene, machine, 2).film, expected))
            << machine.threads << " threads, blocks of " << machine.block_size;
}

std::string described(const WavefrontSettings& w) {
    return "compaction " + std::to_string(w.compact_every) + ", scan " +
           std::to_string(static_cast<int>(w.scan)) + ", sort " +
           std::to_string(static_cast<int>(w.sort)) + ", pool " + std::to_string(w.pool) +
           ", shuffle " + std::to_string(w.shuffle);
}

// POOL-INVAR of the suite of hard cases: nothing about the pool changes a bit.
TEST_P(EveryScene, WavefrontLabHasTheBitsOfTheIterativeOne) {
    const Scene scene = small(GetParam(), 24, 7);
    const Traced expected = trace("02", scene, {}, 2);
    for (const WavefrontSettings& wavefront :
         {WavefrontSettings{}, WavefrontSettings{.compact_every = 0, .pool = 100},
          WavefrontSettings{.compact_every = 3, .scan = ScanKind::serial, .pool = 131},
          WavefrontSettings{.sort = MaterialSort::on, .pool = 500, .shuffle = 9},
          WavefrontSettings{.sort = MaterialSort::queues, .shuffle = 77},
          WavefrontSettings{.sort = MaterialSort::on, .pool = 90, .shuffle = 5, .regenerate = true},
          WavefrontSettings{.compact_every = 2, .sort = MaterialSort::queues, .pool = 77}})
        for (const int block : {32, 1000}) {
            // One host thread: the launches are so small that a second thread would not pay.
            const MachineSettings machine{
                .threads = 1, .block_size = block, .wavefront = wavefront};
            const Traced traced = trace("03", scene, machine, 2);
            ASSERT_EQ(first_difference(traced, expected, scene.camera.width), "")
                << described(wavefront) << ", block " << block;
            ASSERT_TRUE(same_bits(traced.film, expected.film))
                << described(wavefront) << ", block " << block;
        }
}

// Every kernel of the lab, with so few threads that the thread sanitizer can follow them all.
TEST_P(EveryScene, WavefrontLabIsBitIdenticalWithFewPaths) {
    Scene scene = small(GetParam(), 6, 7);
    scene.render.max_depth = std::min(scene.render.max_depth, 3);
    const Film expected = trace("02", scene, {}, 1).film;
    for (const WavefrontSettings& wavefront :
         {WavefrontSettings{.compact_every = 2, .scan = ScanKind::serial},
          WavefrontSettings{.scan = ScanKind::naive, .sort = MaterialSort::on, .pool = 20},
          WavefrontSettings{.scan = ScanKind::efficient, .sort = MaterialSort::queues},
          WavefrontSettings{.scan = ScanKind::warp, .pool = 20, .regenerate = true},
          WavefrontSettings{.scan = ScanKind::lookback, .pool = 20, .shuffle = 9}})
        EXPECT_TRUE(same_bits(
            trace("03", scene, {.block_size = 16, .wavefront = wavefront}, 1).film, expected))
            << described(wavefront);
}

// ACCEL-BRUTE over whole paths: no structure and no walk changes a bit.
TEST_P(EveryScene, AccelLabHasTheBitsOfTheIterativeOne) {
    const Scene scene = small(GetParam(), 16, 7);
    const Traced expected = trace("02", scene, {}, 1);
    const auto same = [&](const AccelSettings& accel) {
        const MachineSettings machine{.threads = 1, .block_size = 64, .accel = accel};
        const Traced traced = trace("04", scene, machine, 1);
        EXPECT_EQ(first_difference(traced, expected, scene.camera.width), "")
            << accel.accel << ", " << accel.walk;
        EXPECT_TRUE(same_bits(traced.film, expected.film)) << accel.accel << ", " << accel.walk;
    };
    same({});
    if (scene.triangles.empty()) return;
    const std::vector<AccelSettings> all = find_lab("04").accels();
    EXPECT_GE(all.size(), 14u);
    for (const AccelSettings& accel : all) same(accel);
}

TEST_P(EveryScene, RecursiveLabIsBitIdenticalForAnyThreadCount) {
    const Scene scene = small(GetParam(), 24, 7);
    const Film expected = trace("01", scene, {.threads = 1}, 2).film;
    EXPECT_TRUE(same_bits(trace("01", scene, {.threads = 3}, 2).film, expected));
}

// A triangle of 1e-14, which no ray of this image meets: whether it is there changes no bit, with
// every structure. Seen from 3 away, all its edges are as near to a ray as double can tell.
TEST(Agreement, ATriangleTooSmallToSeeIsHitByNobody) {
    const auto scene = [](const std::string& speck) {
        const auto triangle = [](const std::string& vertices) {
            return R"({"kind": "triangle", "material": "black", "vertices": [)" + vertices + "]}";
        };
        return parse_scene(R"({"version": 1, "title": "t", "reason": "t",
            "camera": {"position": [0.3, 1.2, 2.5], "look_at": [0, 0, 0], "up": [0, 1, 0],
                       "vfov_deg": 50},
            "film": {"width": 32, "height": 32}, "render": {"max_depth": 4},
            "materials": {
                "grey": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5], "emission": [0, 0, 0]},
                "black": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [0, 0, 0]}},
            "lights": [{"kind": "environment", "radiance": [1, 1, 1]}],
            "shapes": [{"kind": "quad", "material": "grey",
                        "vertices": [[-4, -1, -4], [-4, -1, 4], [4, -1, 4], [4, -1, -4]]}, )" +
                               triangle("[-0.3, -0.3, -0.3], [0.3, -0.3, -0.3], [0, -0.3, 0.3]") +
                               ", " +
                               triangle("[-0.3, -0.3, -0.3], [0.3, -0.3, -0.3], [0, -0.6, 0]") +
                               ", " + triangle("[0.3, -0.3, -0.3], [0, -0.3, 0.3], [0, -0.6, 0]") +
                               ", " + triangle("[0, -0.3, 0.3], [-0.3, -0.3, -0.3], [0, -0.6, 0]") +
                               (speck.empty() ? "" : ", " + triangle(speck)) + "]}",
                           "speck.json");
    };
    const Scene with = scene("[0, 0, 0], [1e-14, 0, 0], [3e-15, 8e-15, 2e-15]"),
                without = scene("");
    ASSERT_EQ(with.triangles.size(), without.triangles.size() + 1);
    const auto same = [&](const std::string& lab, const std::string& accel) {
        const MachineSettings machine{.accel = {accel, "auto"}};
        EXPECT_TRUE(same_bits(trace(lab, with, machine, 8).film, trace("02", without, {}, 8).film))
            << "lab " << lab << ", " << accel;
    };
    for (const char* lab : {"02", "03"}) same(lab, "auto");
    for (const char* accel : {"none", "kd", "lbvh", "sah", "wide"}) same("04", accel);
    EXPECT_TRUE(same_bits(trace("01", with, {}, 8).film, trace("01", without, {}, 8).film));
}

// The comparison itself can fail: another seed parts the paths.
TEST(Agreement, IsNotAlwaysTrue) {
    const Scene a = small("cornell", 24, 1), b = small("cornell", 24, 2);
    const Traced one = trace("01", a, {}, 1), two = trace("02", b, {}, 1);
    EXPECT_NE(first_difference(one, two, a.camera.width), "");
    EXPECT_FALSE(same_bits(one.film, two.film));
}

INSTANTIATE_TEST_SUITE_P(Bundled, EveryScene, testing::ValuesIn(bundled_scenes()),
                         [](const auto& info) { return info.param; });

} // namespace

} // namespace raylab::app
