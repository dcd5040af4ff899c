// The integer intrinsics against the loops that define them.
#include "common/simt/tests/settings.h"

#include <cstdint>
#include <cstring>

using namespace raylab::simt;

namespace {

struct Bits {
    int popc, popcll, clz, clzll, ffs, ffsll, mulhi;
    unsigned brev, umulhi, float_bits;
    unsigned long long brevll;
    float from_bits;
};

__global__ void all_bits(const unsigned long long* in, Bits* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    unsigned long long x = in[i];
    unsigned low = unsigned(x), high = unsigned(x >> 32);
    out[i] = {__popc(low),
              __popcll(x),
              __clz(int(low)),
              __clzll((long long)x),
              __ffs(int(low)),
              __ffsll((long long)x),
              __mulhi(int(low), int(high)),
              __brev(low),
              __umulhi(low, high),
              __float_as_uint(float(low)),
              __brevll(x),
              __uint_as_float(low & 0x3fffffffu)};
}

bool bit(unsigned long long x, int i) { return x >> i & 1; }

int ones(unsigned long long x, int width) {
    int n = 0;
    for (int i = 0; i < width; ++i) n += bit(x, i);
    return n;
}

int leading_zeros(unsigned long long x, int width) {
    int n = 0;
    while (n < width && !bit(x, width - 1 - n)) ++n;
    return n;
}

int first_one(unsigned long long x, int width) {
    for (int i = 0; i < width; ++i)
        if (bit(x, i)) return i + 1;
    return 0;
}

unsigned long long reversed(unsigned long long x, int width) {
    unsigned long long y = 0;
    for (int i = 0; i < width; ++i) y |= (unsigned long long)bit(x, i) << (width - 1 - i);
    return y;
}

} // namespace

TEST(Bits, AgreeWithTheLoopsThatDefineThem) {
    std::vector<unsigned long long> in = {0, 1, 2, 0x80000000u, 0xffffffffu, ~0ull, 1ull << 63};
    for (int i = 0; i < 64; ++i) in.push_back(1ull << i);
    for (unsigned long long x = 1, i = 0; i < 2000; ++i)
        in.push_back(x = x * 6364136223846793005ull + 1442695040888963407ull);
    DeviceArray<unsigned long long> device_in(in);
    DeviceArray<Bits> out(in.size());
    all_bits<<<int(in.size() + 127) / 128, 128>>>(device_in.data(), out.data(), int(in.size()));
    auto got = out.host();
    for (size_t i = 0; i < in.size(); ++i) {
        SCOPED_TRACE(in[i]);
        unsigned low = unsigned(in[i]), high = unsigned(in[i] >> 32);
        EXPECT_EQ(got[i].popc, ones(low, 32));
        EXPECT_EQ(got[i].popcll, ones(in[i], 64));
        EXPECT_EQ(got[i].clz, leading_zeros(low, 32));
        EXPECT_EQ(got[i].clzll, leading_zeros(in[i], 64));
        EXPECT_EQ(got[i].ffs, first_one(low, 32));
        EXPECT_EQ(got[i].ffsll, first_one(in[i], 64));
        EXPECT_EQ(got[i].brev, unsigned(reversed(low, 32)));
        EXPECT_EQ(got[i].brevll, reversed(in[i], 64));
        EXPECT_EQ(got[i].umulhi, unsigned((uint64_t(low) * high) >> 32));
        EXPECT_EQ(got[i].mulhi, int((int64_t(int(low)) * int(high)) >> 32));
        float converted = float(low), from = 0;
        unsigned bits = 0, chosen = low & 0x3fffffffu;
        std::memcpy(&bits, &converted, 4);
        std::memcpy(&from, &chosen, 4);
        EXPECT_EQ(got[i].float_bits, bits);
        EXPECT_EQ(got[i].from_bits, from);
    }
}
