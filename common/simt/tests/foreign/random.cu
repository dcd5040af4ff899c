// cuRAND's sequences, against published numbers.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <curand_kernel.h>

#include <cmath>

namespace {

__global__ void draw(unsigned long long seed, float* out) {
    curandState state;
    curand_init(seed, threadIdx.x, 0, &state);
    out[threadIdx.x] = curand_uniform(&state);
}

template <class State> void test_skipping() {
    for (unsigned long long offset : {0, 1, 3, 4, 5, 1000, 4096}) {
        State stepped, skipped;
        curand_init(77, 5, 0, &stepped);
        curand_init(77, 5, offset, &skipped);
        for (unsigned long long i = 0; i < offset; ++i) curand(&stepped);
        for (int i = 0; i < 9; ++i) ASSERT_EQ(curand(&stepped), curand(&skipped)) << offset;
    }
    // Skipping twice is skipping the sum, also far away.
    State twice, once;
    curand_init(1, 2, 0, &twice);
    curand_init(1, 2 + 12345678901ull, (1ull << 40) + 17, &once);
    skipahead(1ull << 40, &twice);
    skipahead_sequence(12345678901ull, &twice);
    skipahead(17, &twice);
    for (int i = 0; i < 9; ++i) ASSERT_EQ(curand(&twice), curand(&once));
}

// Mean, variance and fourth moment of n numbers; for the last, see below.
struct Moments {
    double mean = 0, variance = 0, fourth = 0;
};
template <class Draw> Moments moments(int n, Draw draw) {
    Moments m;
    for (int i = 0; i < n; ++i) {
        double x = draw();
        m.mean += x / n;
        m.variance += x * x / n;
        m.fourth += x * x * x * x / n;
    }
    return m;
}

// Of a normal number 0, 1 and 3, with deviations of 1, sqrt(2) and sqrt(96) over sqrt(n).
template <class Draw> void test_normal(Draw draw) {
    constexpr int n = 100000;
    Moments m = moments(n, draw);
    double unit = 5 / std::sqrt(double(n));
    EXPECT_NEAR(m.mean, 0, unit);
    EXPECT_NEAR(m.variance, 1, std::sqrt(2) * unit);
    EXPECT_NEAR(m.fourth, 3, std::sqrt(96) * unit);
}

} // namespace

// Known answers of the Random123 distribution (kat_vectors).
TEST(Random, PhiloxGivesTheKnownAnswers) {
    auto equal = [](uint4 a, uint4 b) {
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
    };
    EXPECT_TRUE(equal(philox4x32_10({0, 0, 0, 0}, {0, 0}),
                      {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_TRUE(equal(philox4x32_10({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}),
                      {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_TRUE(equal(
        philox4x32_10({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
        {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
    curandStatePhilox4_32_10_t state;
    curand_init(0, 0, 0, &state);
    EXPECT_EQ(curand(&state), 0x6627e8d5u);
    uint4 rest = curand4(&state);
    EXPECT_EQ(rest.x, 0xe169c58du);
    EXPECT_EQ(rest.z, 0x9b00dbd8u);
    // The pi counter by way of subsequence and offset.
    curand_init(0x299f31d0a4093822ull, 0x0370734413198a2eull, 0, &state);
    skipahead(0x85a308d3243f6a88ull, &state);
    skipahead(0x85a308d3243f6a88ull, &state);
    skipahead(0x85a308d3243f6a88ull, &state);
    skipahead(0x85a308d3243f6a88ull, &state);
    EXPECT_EQ(curand(&state), 0xd16cfe09u);
}

// The first number of each subsequence of seed 1234, as cuRAND 13.0 gives it.
TEST(Random, XorwowHasItsSubsequences) {
    const double numbers[] = {0.1455, 0.8202, 0.5504, 0.2948, 0.9147,
                              0.8690, 0.3219, 0.7829, 0.0113, 0.2855};
    for_each_setting([&] {
        DeviceArray<float> out(10);
        draw<<<1, 10>>>(1234, out.data());
        auto got = out.host();
        for (int i = 0; i < 10; ++i) EXPECT_NEAR(got[i], numbers[i], 0.5001e-4);
    });
}

// What the headers of cuRAND 13.0 give, compiled for a host: the bits exactly, and what goes
// through sine and logarithm up to the last bits of those.
TEST(Random, GivesCurandsNumbers) {
    curandState xorwow;
    curand_init(1234, 0, 0, &xorwow);
    for (unsigned number : {0x253d5e15u, 0x6f558604u, 0xdee6daf2u, 0x7485b394u, 0xdb6a6a85u})
        EXPECT_EQ(curand(&xorwow), number);
    curand_init(0x123456789abcdefull, 77, 1001, &xorwow);
    for (unsigned number : {0x5199df1cu, 0xc781fddeu, 0xd120fc06u, 0xb4f632efu, 0x605554d9u})
        EXPECT_EQ(curand(&xorwow), number);
    curandStatePhilox4_32_10_t philox;
    curand_init(1234, 0, 0, &philox);
    for (unsigned number : {0x2090b348u, 0xda7cf0abu, 0x4401906fu, 0xcbca470eu, 0x9eeede35u})
        EXPECT_EQ(curand(&philox), number);
    curand_init(0x123456789abcdefull, 77, 1001, &philox);
    for (unsigned number : {0x85dca37au, 0xa2fa9a2bu, 0x08adc606u, 0x793a8a5bu, 0x68543e45u})
        EXPECT_EQ(curand(&philox), number);

    curand_init(42, 3, 5, &philox);
    uint4 four = curand4(&philox);
    EXPECT_EQ(four.x, 0x1d91b19bu);
    EXPECT_EQ(four.w, 0x5229c193u);
    EXPECT_EQ(curand_uniform4(&philox).y, 0x1.043e1ap-1f);
    float4 normal = curand_normal4(&philox);
    EXPECT_NEAR(normal.x, -0.52387017f, 1e-6);
    EXPECT_NEAR(normal.w, -0.349065781f, 1e-6);
    EXPECT_EQ(curand_uniform2_double(&philox).x, 0x1.35a008787f6aap-3);
    EXPECT_EQ(curand(&philox), 0x2fa9cf5eu);
}

namespace {

// In the order of the calls.
struct Drawn {
    float uniform;
    double uniform_double;
    float normal[3];
    double normal_double[2];
    float log_normal;
    double log_normal_double;
    float normal_again;
    double second_of_two;
    unsigned next;
};

template <class State> void test_distributions(const Drawn& expected) {
    State state;
    curand_init(42, 3, 5, &state);
    EXPECT_EQ(curand_uniform(&state), expected.uniform);
    EXPECT_EQ(curand_uniform_double(&state), expected.uniform_double);
    for (float normal : expected.normal) EXPECT_NEAR(curand_normal(&state), normal, 1e-6);
    for (double normal : expected.normal_double)
        EXPECT_NEAR(curand_normal_double(&state), normal, 1e-14);
    EXPECT_NEAR(curand_log_normal(&state, 0.5f, 2.0f), expected.log_normal,
                1e-5 * expected.log_normal);
    EXPECT_NEAR(curand_log_normal_double(&state, 0.5, 2.0), expected.log_normal_double,
                1e-13 * expected.log_normal_double);
    EXPECT_NEAR(curand_normal(&state), expected.normal_again, 1e-6);
    EXPECT_NEAR(curand_normal2_double(&state).y, expected.second_of_two, 1e-14);
    EXPECT_EQ(curand(&state), expected.next);
}

} // namespace

// From the same headers.
TEST(Random, DistributionsAreCurands) {
    test_distributions<curandState>({0x1.15f794p-2f,
                                     0x1.42835d5a85614p-1,
                                     {1.33977962f, 0.638184845f, 0.225822642f},
                                     {0.4608381808815234, 0.20270869695457458},
                                     0.938131928f,
                                     1.0056409495833676,
                                     -0.340375394f,
                                     1.1030888359941859,
                                     0x2b5a89f7});
    test_distributions<curandStatePhilox4_32_10_t>({0x1.d91b1ap-4f,
                                                    0x1.5362605ap-1,
                                                    {1.50521863f, -0.719303191f, -0.0243089814f},
                                                    {-1.0936979526302322, 1.2926914713071449},
                                                    26.2874241f,
                                                    76.819115753318115,
                                                    -1.7977457f,
                                                    0.0040820427788962497,
                                                    0x76248e85});
}

TEST(Random, SkippingIsDrawingManyTimes) {
    test_skipping<curandStateXORWOW_t>();
    test_skipping<curandStatePhilox4_32_10_t>();
}

TEST(Random, UniformNumbersAreIn0To1) {
    EXPECT_EQ(uniform(0u), 0x1p-33f);
    EXPECT_EQ(uniform(~0u), 1.0f);
    EXPECT_EQ(uniform(0u, 0u), 0x1p-54);
    EXPECT_LE(uniform(~0u, ~0u), 1.0);
    curandStatePhilox4_32_10_t state;
    curand_init(3, 0, 0, &state);
    Moments m = moments(100000, [&] { return double(curand_uniform4(&state).w) - 0.5; });
    EXPECT_NEAR(m.mean, 0, 5 * std::sqrt(1 / 12.0 / 100000));
    EXPECT_NEAR(m.variance, 1 / 12.0, 0.002);
}

TEST(Random, NormalNumbersHaveTheirMoments) {
    curandState xorwow;
    curandStatePhilox4_32_10_t philox;
    curand_init(1, 2, 3, &xorwow);
    curand_init(1, 2, 3, &philox);
    test_normal([&] { return curand_normal(&xorwow); });
    test_normal([&] { return curand_normal_double(&xorwow); });
    test_normal([&] { return curand_normal(&philox); });
    test_normal([&] { return curand_normal_double(&philox); });
    test_normal([&] { return curand_normal4(&philox).z; });
    test_normal([&] { return std::log(curand_log_normal(&xorwow, 0, 1)); });
}
