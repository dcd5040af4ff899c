// half and bfloat16: IEEE 754's binary16, and the upper half of a float.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <cuda_bf16.h>
#include <cuda_fp16.h>

namespace {

// 2^exponent * fraction, from the definition of the format.
double value_of(unsigned bits, int exponent_bits, int fraction_bits) {
    int exponent = int(bits >> fraction_bits) & ((1 << exponent_bits) - 1);
    double fraction = bits & ((1u << fraction_bits) - 1), one = 1 << fraction_bits;
    int bias = (1 << (exponent_bits - 1)) - 1;
    double size = exponent ? std::pow(2, exponent - bias) * (1 + fraction / one)
                           : std::pow(2, 1 - bias) * (fraction / one);
    return bits >> 15 ? -size : size;
}

// Every finite number comes back; what lies between two neighbours goes to the nearer one, a tie to
// the even one, and by direction.
template <class Number> void test_rounding(int exponent_bits, int fraction_bits) {
    using Bits = typename Number::Bits;
    unsigned infinity = ((1u << exponent_bits) - 1) << fraction_bits;
    for (unsigned bits = 0; bits < infinity; ++bits) {
        double low = value_of(bits, exponent_bits, fraction_bits);
        ASSERT_EQ(float(Number::from_bits(bits)), float(low));
        ASSERT_EQ(Number(float(low)).bits, bits);
        ASSERT_EQ(Number(float(-low)).bits, bits | 0x8000u);
        double high = value_of(bits + 1, exponent_bits, fraction_bits); // the last is 2^emax+1
        double middle = (low + high) / 2;
        ASSERT_EQ(Number(middle).bits, bits + bits % 2);
        ASSERT_EQ(Number(std::nextafter(middle, 0)).bits, middle == 0 ? 0 : bits);
        ASSERT_EQ(Number(std::nextafter(middle, INFINITY)).bits, bits + 1);
        ASSERT_EQ(Bits::from(middle, Round::zero), bits);
        ASSERT_EQ(Bits::from(middle, Round::up), bits + 1);
        ASSERT_EQ(Bits::from(-middle, Round::up), bits | 0x8000u);
        ASSERT_EQ(Bits::from(-middle, Round::down), (bits + 1) | 0x8000u);
    }
    EXPECT_EQ(Number(INFINITY).bits, infinity);
    EXPECT_TRUE(std::isnan(float(Number(NAN))));
}

__global__ void dot(const half2* a, const half2* b, float* out, half* total) {
    half2 product = __hmul2(a[threadIdx.x], b[threadIdx.x]);
    float sum = __low2float(product) + __high2float(product);
    for (int offset = 16; offset; offset /= 2) sum += __shfl_down_sync(0xffffffffu, sum, offset);
    half h = __shfl_sync(0xffffffffu, __low2half(product), 3);
    out[threadIdx.x] = threadIdx.x ? __half2float(h) : sum;
    atomicAdd(total, __float2half(1.0f));
}

} // namespace

TEST(SmallFloats, RoundAsTheirFormatsSay) {
    test_rounding<__half>(5, 10);
    test_rounding<__nv_bfloat16>(8, 7);
    EXPECT_EQ(__half2float(__float2half(65519.0f)), 65504.0f);
    EXPECT_EQ(__half2float(__float2half(65520.0f)), INFINITY);
    EXPECT_EQ(__half2float(__float2half_rz(1e6f)), 65504.0f);
    EXPECT_EQ(__half_as_ushort(__float2half(-2.0f)), 0xc000);
    EXPECT_EQ(__half(__nv_bfloat16(1.5f)).bits, 0x3e00);
    EXPECT_EQ(static_cast<__nv_bfloat16>(__half(-2.0f)).bits, 0xc000);
    EXPECT_EQ(__bfloat16_as_ushort(__float2bfloat16(1.0f)), 0x3f80);
    EXPECT_EQ(__half2int_rn(__float2half(2.5f)), 2);
    EXPECT_EQ(__half2float(__int2half_rn(2049)), 2048.0f);
}

TEST(SmallFloats, ArithmeticIsRoundedOnce) {
    // 2048 + 1 is a tie in half; 1/3 is 0x3555; 0.1f as half times 10.
    half big = 2048.0f, one = 1.0f;
    EXPECT_EQ(float(big + one), 2048.0f);
    EXPECT_EQ(float(__hadd(big, half(3.0f))), 2052.0f);
    EXPECT_EQ(__half_as_ushort(one / half(3.0f)), 0x3555);
    EXPECT_EQ(float(__hadd_sat(big, one)), 1.0f);
    // 1025 * 1025 + 1: a product rounded first would lose the 1.
    half x = half(1.0009765625f); // 1 + 2^-10
    EXPECT_EQ(float(__hfma(x, x, half(-1.001953125f))), std::pow(2.0f, -20));
    // The sum 2^16 * (1 + 2^-11) is a tie but for the tiny term.
    EXPECT_EQ(float(__hfma(half(128.0f), half(256.0625f), half(-0x1p-24f))),
              float(half(128.0 * 256.0 + 8 - 0x1p-24)));
    EXPECT_EQ(float(hsqrt(half(2.0f))), float(half(1.41421356f)));
    EXPECT_TRUE(__hlt(one, big) && __hgt(big, one) && !__heq(one, big) && __hisnan(half(NAN)));
    EXPECT_EQ(float(__hmax(half(NAN), one)), 1.0f);
    EXPECT_EQ(float(__hneg(one)), -1.0f);
    nv_bfloat16 b = 256.0f;
    EXPECT_EQ(float(b + nv_bfloat16(1.0f)), 256.0f);
    EXPECT_EQ(float(b * nv_bfloat16(3.0f)), 768.0f);
}

TEST(SmallFloats, PairsAndKernels) {
    half2 p = __floats2half2_rn(1.5f, -2.0f), q = __float2half2_rn(2.0f);
    EXPECT_EQ(__half22float2(__hfma2(p, q, q)).x, 5.0f);
    EXPECT_EQ(__high2float(p * q), -4.0f);
    EXPECT_TRUE(__hbge2(q, p));
    EXPECT_EQ(__low2float(__lowhigh2highlow(p)), -2.0f);
    EXPECT_EQ(sizeof(half2), 4u);
    std::vector<half2> a(32), b(32);
    for (int i = 0; i < 32; ++i)
        a[i] = __floats2half2_rn(float(i), 1.0f), b[i] = __floats2half2_rn(2.0f, float(i));
    DeviceArray<half2> device_a(a), device_b(b);
    DeviceArray<float> out(32);
    DeviceArray<half> total(1, half(0.0f));
    dot<<<1, 32>>>(device_a.data(), device_b.data(), out.data(), total.data());
    auto got = out.host();
    EXPECT_EQ(got[0], 3 * 31 * 32 / 2);
    EXPECT_EQ(got[1], 6.0f);
    EXPECT_EQ(float(total.host()[0]), 32.0f);
}
