// Integer and floating-point intrinsics, against the definitions in the CUDA math API's manual.
#include "common/simt/tests/settings.h"

#include <cfenv>
#include <cfloat>
#include <climits>
#include <complex>
#include <cuComplex.h>
#include <math_constants.h>

using namespace raylab::simt;

// Of this name and place in programs, where C++20 may have another one.
inline __host__ __device__ float lerp(float a, float b, float t) { return a + t * (b - a); }

namespace {

// Pseudorandom numbers for operands.
unsigned next_random() {
    static unsigned long long state = 1;
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return unsigned(state >> 32);
}

} // namespace

TEST(ForeignIntegers, ProductsMeansAndDifferences) {
    EXPECT_EQ(__mul24(0x7fffff, 2), 0xfffffe);
    EXPECT_EQ(__mul24(-3, 5), -15);
    EXPECT_EQ(__mul24(0x01000003, 5), 15); // bit 24 does not count
    EXPECT_EQ(__umul24(0xff000003u, 5), 15u);
    EXPECT_EQ(__mul64hi(LLONG_MAX, 4), 1);
    EXPECT_EQ(__mul64hi(-1, 1), -1);
    EXPECT_EQ(__umul64hi(~0ull, ~0ull), ~0ull - 1);
    EXPECT_EQ(__sad(INT_MIN, INT_MAX, 1), 0u); // 2^32 - 1 + 1
    EXPECT_EQ(__usad(3, 10, 2), 9u);
    EXPECT_EQ(__hadd(INT_MAX, INT_MAX), INT_MAX);
    EXPECT_EQ(__hadd(-1, 2), 0);
    EXPECT_EQ(__rhadd(-1, 2), 1);
    EXPECT_EQ(__uhadd(~0u, ~0u - 1), ~0u - 1);
    EXPECT_EQ(__urhadd(~0u, ~0u - 1), ~0u);
    EXPECT_EQ(__dp4a(0x01ff02fe, 0x01010203, 10), 10 + 1 - 1 + 2 * 2 - 2 * 3);
    EXPECT_EQ(__fns(0b10110, 0, 2), 2u);
    EXPECT_EQ(__fns(0b10110, 4, -2), 2u);
    EXPECT_EQ(__fns(0b10110, 0, 4), 0xffffffffu);
    EXPECT_EQ(max(-1, 1u), ~0u); // as in C, -1 becomes unsigned
    EXPECT_EQ(min(1.5f, 0.5), 0.5);
}

TEST(ForeignIntegers, BytesAndShifts) {
    EXPECT_EQ(__byte_perm(0x33221100, 0x77665544, 0x3210), 0x33221100u);
    EXPECT_EQ(__byte_perm(0x33221100, 0x77665544, 0x7654), 0x77665544u);
    EXPECT_EQ(__byte_perm(0x33221100, 0x77665544, 0x0123), 0x00112233u);
    EXPECT_EQ(__byte_perm(0x000000f0, 0, 0x8888), 0xffffffffu); // sign of byte 0
    for (unsigned shift = 0; shift < 40; ++shift) {
        unsigned low = next_random(), high = next_random();
        unsigned long long both = (unsigned long long)high << 32 | low;
        EXPECT_EQ(__funnelshift_l(low, high, shift), unsigned(both << shift % 32 >> 32));
        EXPECT_EQ(__funnelshift_r(low, high, shift), unsigned(both >> shift % 32));
        unsigned clamped = shift < 32 ? shift : 32;
        EXPECT_EQ(__funnelshift_rc(low, high, shift), unsigned(both >> clamped));
        EXPECT_EQ(__funnelshift_lc(low, high, shift),
                  clamped == 32 ? low : unsigned(both << clamped >> 32));
    }
}

TEST(ForeignNumbers, ConversionsRoundAndSaturate) {
    EXPECT_EQ(__float2int_rn(2.5f), 2);
    EXPECT_EQ(__float2int_rn(3.5f), 4);
    EXPECT_EQ(__float2int_rz(-2.7f), -2);
    EXPECT_EQ(__float2int_ru(2.1f), 3);
    EXPECT_EQ(__float2int_rd(-2.1f), -3);
    EXPECT_EQ(__float2int_rn(3e9f), INT_MAX);
    EXPECT_EQ(__float2int_rn(-3e9f), INT_MIN);
    EXPECT_EQ(__float2int_rn(CUDART_NAN_F), 0);
    EXPECT_EQ(__float2uint_rn(-1.0f), 0u);
    EXPECT_EQ(__float2uint_rn(5e9f), UINT_MAX);
    EXPECT_EQ(__double2ll_rn(1e30), LLONG_MAX);
    EXPECT_EQ(__int2float_rz(0x7fffffff), 2147483520.0f);
    EXPECT_EQ(__int2float_ru(0x7fffffff), 2147483648.0f);
    EXPECT_EQ(__double2float_rd(0.1), std::nextafter(0.1f, 0.0f));
    EXPECT_EQ(__hiloint2double(__double2hiint(-1.7), __double2loint(-1.7)), -1.7);
    EXPECT_EQ(__int_as_float(0x3f800000), 1.0f);
    EXPECT_EQ(__float_as_uint(-0.0f), 0x80000000u);
}

// The processor's own rounding modes are the truth.
TEST(ForeignNumbers, DirectedRoundingIsTheProcessors) {
    for (int i = 0; i < 20000; ++i) {
        float a = __int_as_float(int(next_random() & 0x8fffffff) | 0x38000000),
              b = __int_as_float(int(next_random() & 0x87ffffff) | 0x3c000000);
        float c = float(int(next_random())) * 1e-6f;
        volatile float x = a, y = b, z = std::abs(a);
        volatile double dx = a * 1.1, dy = b * 1.3;
        struct Mode {
            int mode;
            float add, sub, mul, div, sqrt, fma;
            double dadd, dmul, ddiv;
        } modes[] = {{FE_TOWARDZERO, __fadd_rz(a, b), __fsub_rz(a, b), __fmul_rz(a, b),
                      __fdiv_rz(a, b), __fsqrt_rz(z), __fmaf_rz(a, b, c), __dadd_rz(dx, dy),
                      __dmul_rz(dx, dy), __ddiv_rz(dx, dy)},
                     {FE_UPWARD, __fadd_ru(a, b), __fsub_ru(a, b), __fmul_ru(a, b), __fdiv_ru(a, b),
                      __fsqrt_ru(z), __fmaf_ru(a, b, c), __dadd_ru(dx, dy), __dmul_ru(dx, dy),
                      __ddiv_ru(dx, dy)},
                     {FE_DOWNWARD, __fadd_rd(a, b), __fsub_rd(a, b), __fmul_rd(a, b),
                      __fdiv_rd(a, b), __fsqrt_rd(z), __fmaf_rd(a, b, c), __dadd_rd(dx, dy),
                      __dmul_rd(dx, dy), __ddiv_rd(dx, dy)}};
        for (const Mode& mode : modes) {
            std::fesetround(mode.mode);
            volatile float add = x + y, sub = x - y, mul = x * y, div = x / y;
            volatile double dadd = dx + dy, dmul = dx * dy, ddiv = dx / dy;
            volatile long double exact = (long double)x * y + c; // 64 bits are enough for these
            volatile float fma = float(exact);
            std::fesetround(FE_TONEAREST);
            ASSERT_EQ(mode.add, add) << a << " " << b << " mode " << mode.mode;
            ASSERT_EQ(mode.sub, sub) << a << " " << b << " mode " << mode.mode;
            ASSERT_EQ(mode.mul, mul) << a << " " << b << " mode " << mode.mode;
            ASSERT_EQ(mode.div, div) << a << " " << b << " mode " << mode.mode;
            ASSERT_EQ(mode.fma, fma) << a << " " << b << " " << c << " mode " << mode.mode;
            ASSERT_EQ(mode.dadd, dadd);
            ASSERT_EQ(mode.dmul, dmul);
            ASSERT_EQ(mode.ddiv, ddiv);
            double square = double(mode.sqrt) * mode.sqrt; // exact
            if (mode.mode == FE_UPWARD)
                ASSERT_GE(square, double(z));
            else
                ASSERT_LE(square, double(z));
        }
    }
}

TEST(ForeignNumbers, FunctionsThatTheStandardLacks) {
    for (float x : {-2.5f, -2.0f, -1.0f, -0.25f, 0.0f, 0.5f, 1.0f, 1.25f, 1.5f, 3.0f}) {
        EXPECT_NEAR(sinpif(x), std::sin(x * M_PI), 1e-6);
        EXPECT_NEAR(cospif(x), std::cos(x * M_PI), 1e-6);
        float s = 0, c = 0;
        sincospif(x, &s, &c);
        EXPECT_EQ(s, sinpif(x));
        EXPECT_EQ(c, cospif(x));
    }
    EXPECT_EQ(sinpif(1.0f), 0.0f);
    EXPECT_EQ(cospif(0.5f), 0.0f);
    EXPECT_NEAR(exp10f(2.0f), 100.0f, 1e-5);
    EXPECT_EQ(rcbrtf(8.0f), 0.5f);
    EXPECT_FLOAT_EQ(rhypotf(3, 4), 0.2f);
    EXPECT_FLOAT_EQ(norm3df(2, 3, 6), 7.0f);
    EXPECT_FLOAT_EQ(norm4df(1, 3, 5, 1), 6.0f);
    EXPECT_EQ(normcdff(0), 0.5f);
    EXPECT_NEAR(normcdf(1.959963984540054), 0.975, 1e-12);
    EXPECT_EQ(__saturatef(CUDART_NAN_F), 0.0f);
    EXPECT_EQ(__saturatef(CUDART_INF_F), 1.0f);
    EXPECT_EQ(__fdividef(1, 4), 0.25f);
    EXPECT_EQ(CUDART_PI_F, float(M_PI));
}

TEST(ForeignNumbers, NamesOfLaterStandardsAreFree) { EXPECT_EQ(lerp(1.f, 3.f, 0.25f), 1.5f); }

TEST(ForeignNumbers, ComplexNumbersAreThoseOfTheStandard) {
    for (int i = 0; i < 100; ++i) {
        auto part = [] { return double(int(next_random())); };
        std::complex<double> a{part(), part()}, b{part(), part()};
        auto x = make_cuDoubleComplex(a.real(), a.imag()),
             y = make_cuDoubleComplex(b.real(), b.imag());
        auto quotient = cuCdiv(x, y), product = cuCmul(x, y);
        EXPECT_NEAR(std::abs(std::complex(quotient.x, quotient.y) - a / b), 0, 1e-13 * abs(a / b));
        EXPECT_NEAR(std::abs(std::complex(product.x, product.y) - a * b), 0, 1e-13 * abs(a * b));
        EXPECT_NEAR(cuCabs(x), std::abs(a), 1e-13 * std::abs(a));
    }
    EXPECT_EQ(cuCimagf(cuConjf(make_cuComplex(1, 2))), -2);
    // The square of b would overflow.
    EXPECT_EQ(cuCrealf(cuCdivf(make_cuComplex(1e30f, 0), make_cuComplex(1e30f, 0))), 1);
}
