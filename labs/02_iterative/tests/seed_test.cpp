// Task 2.4: random numbers that belong to the path, and to no other path, pixel, sample or seed.
#include "common/task/facts.h"
#include "labs/02_iterative/tests/small_renders.h"

#include <algorithm>
#include <cmath>

namespace raylab::lab02 {

namespace {

using namespace task;

using Values = std::vector<double>; // of the pixels

// Samples 0 to n - 1 of every pixel, each by itself.
std::vector<Values> samples_of(const Scene& scene, int n) {
    const std::unique_ptr<Renderer> renderer = make_renderer(scene, {});
    std::vector<Values> samples;
    Values sum(scene.camera.width * scene.camera.height, 0);
    for (int k = 0; k < n; ++k) {
        renderer->add_iteration();
        const Film film = renderer->film();
        Values sample;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sample.push_back(film.pixels[i].sum[0] - sum[i]);
            sum[i] = film.pixels[i].sum[0];
        }
        samples.push_back(sample);
    }
    return samples;
}

// Two paths of the same numbers differ in their last digits at most. Those of different numbers are
// that near with a probability of about 1e-5.
bool alike(double a, double b) { return std::fabs(a - b) <= 1e-5 * std::fabs(a); }

// The share of the pixels i of `a` that are alike to pixel other(i) of b, where b has it.
template <class Other> double share_alike(const Values& a, const Values& b, const Other& other) {
    double n = 0, same = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (other(i) < b.size()) ++n, same += alike(a[i], b[other(i)]);
    return same / n;
}

const auto itself = [](std::size_t i) { return i; };
const auto next = [](std::size_t i) { return i + 1; };
const auto twice = [](std::size_t i) { return 2 * i + 1; };
const auto double_of = [](std::size_t i) { return 2 * i; };

// Of right random numbers the share is 1e-5; a tenth of 288 pairs and more is never met by chance.
bool expect_own(const std::string& what, double share, const std::string& cause) {
    return expect(share < 0.1, fmt::format("{}: {:.0f} % of the pixels have the same value; the "
                                           "likely cause: {}",
                                           what, 100 * share, cause));
}

TEST(Task2_4, TheLaunchDoesNotChangeTheImage) {
    const Scene scene = noisy(24, 1);
    const Film film = render(scene, {.threads = 1, .block_size = 128}, 2);
    const std::string cause = "random numbers keyed by pixel and sample, never by threadIdx or a "
                              "generator that threads share";
    expect(same_bits(render(scene, {.threads = 2, .block_size = 32}, 2), film),
           "the image in blocks of 32 should have the same bits as in blocks of 128; the likely "
           "cause: " +
               cause);
    expect(same_bits(render(scene, {.threads = 2, .order = ThreadOrder::reverse}, 2), film),
           "the image with threads in reverse order should have the same bits; the likely cause: " +
               cause);
}

// 24 x 24 pixels: their numbers need ten bits.
TEST(Task2_4, EveryPixelHasNumbersOfItsOwn) {
    const std::vector<Values> samples = samples_of(noisy(24, 1), 2);
    const auto first = [](std::size_t) { return std::size_t{1}; };
    const bool later = share_alike(samples[1], samples[1], first) < 0.1;
    if (!expect_own("all pixels against pixel 1", share_alike(samples[0], samples[0], first),
                    later ? "the pixel's number enters in a product with the sample's, which is 0 "
                            "at first"
                          : "the pixel's number does not enter the random numbers") ||
        !expect_own("pixels 256 apart",
                    share_alike(samples[0], samples[0], [](std::size_t i) { return i + 256; }),
                    "only some bits of the pixel's number enter: all bits of it are needed, "
                    "without % or &"))
        return;
    const Values large = samples_of(noisy(24, 0x9e3779b1u), 1)[0];
    expect_own("neighbours, where the seed is 2654435761", share_alike(large, large, next),
               "a number that is computed in float: above 2^24 neighbours round to the same");
}

TEST(Task2_4, EverySampleHasNumbersOfItsOwn) {
    const std::vector<Values> samples = samples_of(noisy(24, 1), 2);
    if (!expect_own("sample 1 against sample 0", share_alike(samples[0], samples[1], itself),
                    "the sample's number does not enter the random numbers") ||
        !expect_own("sample 1 of each pixel against sample 0 of the next",
                    share_alike(samples[1], samples[0], next),
                    "pixel and sample enter as their sum: 3 + 1 is 4 + 0") ||
        !expect_own("sample 1 of pixel i against sample 0 of pixel 2 i + 1",
                    share_alike(samples[1], samples[0], twice),
                    "pixel and sample enter as a product: 1 * 4 is 2 * 2") ||
        !expect_own("sample 1 of pixel i against sample 0 of pixel 2 i",
                    share_alike(samples[1], samples[0], double_of),
                    "pixel and sample enter as a product: 1 * 4 is 2 * 2"))
        return;
    const std::vector<Values> many = samples_of(noisy(8, 1), 257);
    expect_own("sample 256 against sample 0", share_alike(many[0], many[256], itself),
               "only some bits of the sample's number enter: all bits of it are needed");
}

TEST(Task2_4, EverySeedHasNumbersOfItsOwn) {
    const auto first_sample = [](std::uint32_t seed) { return samples_of(noisy(24, seed), 1)[0]; };
    const Values one = first_sample(1), two = first_sample(2);
    if (!expect_own("seed 2 against seed 1", share_alike(one, two, itself),
                    "the seed does not enter the random numbers") ||
        !expect_own("seed 2 against the next pixel with seed 1", share_alike(two, one, next),
                    "the seed enters as a sum, seed plus pixel: an image is the last one, moved "
                    "by a pixel") ||
        !expect_own("seed 2 against pixel 2 i with seed 1", share_alike(two, one, double_of),
                    "the seed enters as a product, seed times pixel"))
        return;
    for (const std::uint32_t seed : {1u + 256, 1u + 65536})
        if (!expect_own(fmt::format("seed {} against seed 1", seed),
                        share_alike(one, first_sample(seed), itself),
                        "only some bits of the seed enter: all bits of it are needed"))
            return;
}

// What no test above has named: of 6912 values, two are alike by chance about 50 times.
TEST(Task2_4, NoTwoPathsShareNumbers) {
    Values values;
    for (const std::uint32_t seed : {1u, 2u, 5u})
        for (const Values& sample : samples_of(noisy(24, seed), 4))
            values.insert(values.end(), sample.begin(), sample.end());
    std::sort(values.begin(), values.end());
    int pairs = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        pairs += values[i] - values[i - 1] <= 1e-7 * values[i];
    expect(pairs < 345,
           fmt::format("of 6912 paths, of 3 seeds, 576 pixels and 4 samples, {} have the value of "
                       "another; the likely cause: seed, pixel and sample enter as a sum, a "
                       "product or an xor, in place of three numbers that are hashed",
                       pairs));
}

// Noise has no pattern: the correlation of n independent pairs is 0 with standard error 1/sqrt(n).
// 4.5 of these: a false alarm in 147,000.
TEST(Task2_4, NeighboursAreIndependent) {
    constexpr int side = 32;
    const Film film = render(noisy(side, 3), {}, 1);
    const auto correlation = [&](int dx, int dy) {
        double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
        for (int y = 0; y + dy < side; ++y)
            for (int x = 0; x + dx < side; ++x) {
                const double p = film.pixels[y * side + x].sum[0];
                const double q = film.pixels[(y + dy) * side + x + dx].sum[0];
                n += 1, a += p, b += q, aa += p * p, bb += q * q, ab += p * q;
            }
        return (n * ab - a * b) / std::sqrt((n * aa - a * a) * (n * bb - b * b));
    };
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {16, 0}})
        expect_near(fmt::format("correlation of pixels ({}, {}) apart", dx, dy),
                    correlation(dx, dy), 0, 4.5 / side + 0.02,
                    "numbers of neighbouring pixels resemble each other: hash the key, or seeds "
                    "that differ by one give streams that differ by little");
}

} // namespace

} // namespace raylab::lab02
