// index_of has an answer for every number there is.
#include "common/math/index.h"
#include "common/math/numbers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>

namespace raylab {
namespace {

constexpr int counts[] = {1, 2, 7, 1 << 24, (1 << 24) + 1, std::numeric_limits<int>::max()};

template <class Real> void expect_hard_cases() {
    constexpr Real inf = std::numeric_limits<Real>::infinity();
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const int count : counts) {
        for (const Real x : {nan, -nan, -inf, Real(-1e30), Real(-1), Real(-1e-30), Real(-0.0),
                             Real(0), std::numeric_limits<Real>::denorm_min(), Real(0.999)})
            EXPECT_EQ(index_of(x, count), 0) << x;
        for (const Real x :
             {inf, std::numeric_limits<Real>::max(), Real(1e30), Real(0x1p31), Real(0x1p32)})
            EXPECT_EQ(index_of(x, count), count - 1) << x;
    }
    EXPECT_EQ(index_of(Real(6.5), 7), 6);
    EXPECT_EQ(index_of(Real(7), 7), 6);
    EXPECT_EQ(index_of(Real(1e9), std::numeric_limits<int>::max()), 1'000'000'000);
    EXPECT_EQ(index_of(Real(0x1p31) - Real(128), 1 << 24), (1 << 24) - 1);
}

TEST(Index, nan_infinity_and_what_does_not_fit) {
    expect_hard_cases<float>();
    expect_hard_cases<double>();
}

// Over all floats, every 9973rd by its bits: the bounds hold, and where a plain conversion is
// defined and inside, it is that.
TEST(Index, sweep_of_all_floats) {
    for (std::uint64_t bits = 0; bits < 1ull << 32; bits += 9973) {
        const auto word = static_cast<std::uint32_t>(bits);
        float x;
        std::memcpy(&x, &word, sizeof x);
        for (const int count : counts) {
            const int i = index_of(x, count);
            ASSERT_TRUE(0 <= i && i < count) << x << " of " << count;
            if (x >= 0 && double(x) < count) {
                ASSERT_EQ(i, static_cast<int>(x)) << count;
            }
        }
    }
}

} // namespace
} // namespace raylab
