// Match, reduce, shuffles of small types, and CUDA 8's operations without a mask.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

namespace {

struct Found {
    unsigned any, all, sum, smallest, largest, conjunction, disjunction, parity;
    int equal, least;
};

__global__ void find(Found* found, int divisor) {
    unsigned lane = threadIdx.x % 32;
    unsigned half = lane < 16 ? 0x0000ffffu : 0xffff0000u;
    Found f{};
    f.any = __match_any_sync(half, int(lane) / divisor);
    f.all = __match_all_sync(half, double(lane / divisor), &f.equal);
    f.sum = __reduce_add_sync(half, lane);
    f.smallest = __reduce_min_sync(half, lane + 5);
    f.largest = __reduce_max_sync(half, lane + 5);
    f.conjunction = __reduce_and_sync(half, lane | 0x100);
    f.disjunction = __reduce_or_sync(half, lane);
    f.parity = __reduce_xor_sync(half, lane & 1);
    f.least = __reduce_min_sync(half, -int(lane));
    found[threadIdx.x] = f;
}

__global__ void shuffle_small(int* out) {
    int lane = threadIdx.x % 32;
    bool odd = lane % 2;
    short s = short(-lane);
    char c = char(lane);
    int a = __shfl_xor_sync(0xffffffffu, odd, 1);
    int b = __shfl_sync(0xffffffffu, s, 3);
    int d = __shfl_down_sync(0xffffffffu, c, 1);
    out[threadIdx.x] = a * 10000 + -b * 100 + d;
}

__global__ void without_mask(int* out) {
    int lane = threadIdx.x % 32, value = lane;
    for (int offset = 16; offset > 0; offset /= 2) value += __shfl_down(value, offset);
    if (lane < 8) out[32 + lane] = __ballot(lane % 2) == 0xaa && __any(lane == 7) && !__all(lane);
    if (lane == 0) out[0] = value;
}

// Waits for a thread that comes later in the block.
__global__ void patient(int* flag) {
    if (threadIdx.x == 0)
        while (atomicAdd(flag, 0) == 0) __nanosleep(100);
    if (threadIdx.x == 40) atomicExch(flag, 1);
}

} // namespace

TEST(ForeignWarp, MatchAndReduceSeeTheLanesOfTheMask) {
    for_each_setting([] {
        for (int divisor : {1, 3, 16}) {
            DeviceArray<Found> found(64);
            find<<<1, 64>>>(found.data(), divisor);
            auto got = found.host();
            for (int t = 0; t < 64; ++t) {
                int lane = t % 32, first = lane / 16 * 16;
                unsigned same = 0, sum = 0, any_bit = 0, all_bits = ~0u;
                for (int other = first; other < first + 16; ++other) {
                    if (other / divisor == lane / divisor) same |= 1u << other;
                    sum += other;
                    any_bit |= other;
                    all_bits &= other | 0x100;
                }
                unsigned half = 0xffffu << first;
                ASSERT_EQ(got[t].any, same);
                ASSERT_EQ(got[t].equal != 0, same == half);
                ASSERT_EQ(got[t].all, same == half ? half : 0);
                ASSERT_EQ(got[t].sum, sum);
                ASSERT_EQ(got[t].smallest, unsigned(first + 5));
                ASSERT_EQ(got[t].largest, unsigned(first + 20));
                ASSERT_EQ(got[t].conjunction, all_bits);
                ASSERT_EQ(got[t].disjunction, any_bit);
                ASSERT_EQ(got[t].parity, 0u);
                ASSERT_EQ(got[t].least, -(first + 15));
            }
        }
    });
}

TEST(ForeignWarp, ShufflesTakeSmallTypesAsInts) {
    DeviceArray<int> out(32);
    shuffle_small<<<1, 32>>>(out.data());
    auto got = out.host();
    for (int lane = 0; lane < 32; ++lane)
        EXPECT_EQ(got[lane], (lane % 2 ? 0 : 10000) + 300 + std::min(lane + 1, 31));
}

TEST(ForeignWarp, OldOperationsActOnTheLanesThatAreThere) {
    for_each_setting([] {
        DeviceArray<int> out(64);
        without_mask<<<1, 32>>>(out.data());
        auto got = out.host();
        EXPECT_EQ(got[0], 31 * 32 / 2);
        for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(got[32 + lane], 1);
    });
}

TEST(ForeignWarp, SleepingLetsLaterThreadsRun) {
    DeviceArray<int> flag(1);
    patient<<<1, 64>>>(flag.data());
    EXPECT_EQ(flag.host()[0], 1);
}
