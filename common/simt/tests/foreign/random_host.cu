// cuRAND's host API: the numbers of the device API's generators, and Sobol's nets.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <curand.h>
#include <curand_kernel.h>

#include <cmath>
#include <set>
#include <vector>

namespace {

struct Generator {
    curandGenerator_t it = nullptr;
    explicit Generator(curandRngType_t type) {
        EXPECT_EQ(curandCreateGeneratorHost(&it, type), CURAND_STATUS_SUCCESS);
    }
    ~Generator() { curandDestroyGenerator(it); }
};

TEST(RandomHost, CallsGoOnInTheDeviceApisSequence) {
    Generator generator(CURAND_RNG_PSEUDO_DEFAULT);
    curandSetPseudoRandomGeneratorSeed(generator.it, 99);
    std::vector<float> numbers(10);
    ASSERT_EQ(curandGenerateUniform(generator.it, numbers.data(), 4), CURAND_STATUS_SUCCESS);
    ASSERT_EQ(curandGenerateUniform(generator.it, numbers.data() + 4, 6), CURAND_STATUS_SUCCESS);
    curandState state;
    curand_init(99, 0, 0, &state);
    for (float number : numbers) EXPECT_EQ(number, curand_uniform(&state));
}

TEST(RandomHost, FillsDeviceMemory) {
    curandGenerator_t generator;
    ASSERT_EQ(curandCreateGenerator(&generator, CURAND_RNG_PSEUDO_PHILOX4_32_10),
              CURAND_STATUS_SUCCESS);
    double *device, host[2000];
    cudaMalloc(&device, sizeof host);
    ASSERT_EQ(curandGenerateNormalDouble(generator, device, 2000, 3, 2), CURAND_STATUS_SUCCESS);
    cudaMemcpy(host, device, sizeof host, cudaMemcpyDeviceToHost);
    double sum = 0, squares = 0;
    for (double x : host) {
        sum += x;
        squares += (x - 3) * (x - 3);
    }
    EXPECT_NEAR(sum / 2000, 3, 5 * 2 / std::sqrt(2000)) << "five standard errors";
    EXPECT_NEAR(squares / 2000, 4, 5 * 4 * std::sqrt(2.0 / 2000));
    cudaFree(device);
    curandDestroyGenerator(generator);
}

TEST(RandomHost, RefusesWhatItHasNot) {
    curandGenerator_t generator;
    EXPECT_EQ(curandCreateGenerator(&generator, CURAND_RNG_PSEUDO_MTGP32),
              CURAND_STATUS_TYPE_ERROR);
    Generator sobol(CURAND_RNG_QUASI_SOBOL32), xorwow(CURAND_RNG_PSEUDO_XORWOW);
    float numbers[4];
    EXPECT_EQ(curandSetQuasiRandomGeneratorDimensions(sobol.it, 9), CURAND_STATUS_OUT_OF_RANGE);
    EXPECT_EQ(curandSetQuasiRandomGeneratorDimensions(sobol.it, 3), CURAND_STATUS_SUCCESS);
    EXPECT_EQ(curandGenerateUniform(sobol.it, numbers, 4), CURAND_STATUS_LENGTH_NOT_MULTIPLE);
    EXPECT_EQ(curandGenerateNormal(sobol.it, numbers, 3, 0, 1), CURAND_STATUS_TYPE_ERROR);
    EXPECT_EQ(curandGenerateNormal(xorwow.it, numbers, 3, 0, 1), CURAND_STATUS_LENGTH_NOT_MULTIPLE);
}

// 256 points: in each dimension one lies in each 256th. Of the first two dimensions one lies in
// each rectangle of area 1/256 (Sobol 1967, (t, m, s)-nets with t = 0).
TEST(RandomHost, SobolPointsAreNets) {
    constexpr unsigned dimensions = 8, points = 256;
    Generator generator(CURAND_RNG_QUASI_SOBOL32);
    curandSetQuasiRandomGeneratorDimensions(generator.it, dimensions);
    std::vector<unsigned> x(points * dimensions);
    ASSERT_EQ(curandGenerate(generator.it, x.data(), x.size()), CURAND_STATUS_SUCCESS);
    for (unsigned d = 0; d < dimensions; ++d) {
        std::set<unsigned> strata;
        for (unsigned i = 0; i < points; ++i) strata.insert(x[d * points + i] >> 24);
        EXPECT_EQ(strata.size(), points) << "dimension " << d;
    }
    for (unsigned columns = 1; columns < 8; ++columns) { // as a power of two
        std::set<std::pair<unsigned, unsigned>> cells;
        for (unsigned i = 0; i < points; ++i)
            cells.insert({x[i] >> (32 - columns), x[points + i] >> (32 - (8 - columns))});
        EXPECT_EQ(cells.size(), points) << columns;
    }
}

TEST(RandomHost, SobolBeginsWithTheNumbersOfJoeAndKuo) {
    // Their program's first points of three dimensions; it, too, goes in the order of Gray codes.
    const float expected[3][6] = {{0, .5f, .75f, .25f, .375f, .875f},
                                  {0, .5f, .25f, .75f, .375f, .875f},
                                  {0, .5f, .25f, .75f, .625f, .125f}};
    curandDirectionVectors32_t* vectors;
    curandDirectionVectors64_t* long_vectors;
    ASSERT_EQ(curandGetDirectionVectors32(&vectors, CURAND_DIRECTION_VECTORS_32_JOEKUO6),
              CURAND_STATUS_SUCCESS);
    ASSERT_EQ(curandGetDirectionVectors64(&long_vectors, CURAND_DIRECTION_VECTORS_64_JOEKUO6),
              CURAND_STATUS_SUCCESS);
    for (int d = 0; d < 3; ++d)
        for (unsigned first : {0u, 2u}) {
            curandStateSobol32 state;
            curandStateSobol64 long_state;
            curand_init(vectors[d], first, &state);
            curand_init(long_vectors[d], first, &long_state);
            for (unsigned i = first; i < 6; ++i) {
                EXPECT_EQ(float(curand(&state)) * 0x1p-32f, expected[d][i]) << d << " " << i;
                EXPECT_EQ(float(curand(&long_state)) * 0x1p-64f, expected[d][i]) << d << " " << i;
            }
        }
}

} // namespace
