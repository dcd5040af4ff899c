// Shuffles, votes and barriers of a warp against what each lane must get, lane by lane.
#include "common/simt/tests/settings.h"

#include <cmath>

using namespace raylab::simt;

namespace {

enum Shuffle { plain, up, down, exclusive_or };

template <class T>
__global__ void shuffle(Shuffle kind, const T* in, int amount, int width, T* out) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    T value = in[i];
    if (kind == plain) out[i] = __shfl_sync(0xffffffffu, value, amount, width);
    if (kind == up) out[i] = __shfl_up_sync(0xffffffffu, value, amount, width);
    if (kind == down) out[i] = __shfl_down_sync(0xffffffffu, value, amount, width);
    if (kind == exclusive_or) out[i] = __shfl_xor_sync(0xffffffffu, value, amount, width);
}

// The lane whose value lane `lane` gets, from the CUDA C++ Programming Guide, "Warp Shuffle
// Functions".
int source_of(Shuffle kind, int lane, int amount, int width) {
    int segment = lane / width * width, last = segment + width - 1;
    if (kind == plain) return segment + (amount % width + width) % width;
    if (kind == up) return lane - amount < segment ? lane : lane - amount;
    if (kind == down) return lane + amount > last ? lane : lane + amount;
    return (lane ^ amount) > last ? lane : lane ^ amount;
}

template <class T> void test_shuffles() {
    constexpr int blocks = 2, threads = 96;
    std::vector<T> in(blocks * threads);
    for (size_t i = 0; i < in.size(); ++i) in[i] = T(T(i) * T(1.5e6) + T(i) / T(3));
    DeviceArray<T> device_in(in);
    for (Shuffle kind : {plain, up, down, exclusive_or})
        for (int width = 1; width <= 32; width *= 2)
            for (int amount : {0, 1, 2, 3, 7, 15, 16, 31}) {
                DeviceArray<T> out(in.size());
                shuffle<T><<<blocks, threads>>>(kind, device_in.data(), amount, width, out.data());
                auto got = out.host();
                for (int i = 0; i < blocks * threads; ++i)
                    ASSERT_EQ(got[i], in[i / 32 * 32 + source_of(kind, i % 32, amount, width)])
                        << "kind " << kind << ", width " << width << ", amount " << amount
                        << ", thread " << i;
            }
}

// Every lane brings whether its bit of `pattern` is set; odd and even lanes vote apart.
__global__ void votes(unsigned pattern, unsigned* ballots, int* any, int* all) {
    int i = blockIdx.x * blockDim.x + threadIdx.x, lane = threadIdx.x % 32;
    int mine = pattern >> lane & 1 ? 7 : 0;
    ballots[i] = __ballot_sync(0xffffffffu, mine);
    if (lane % 2) {
        any[i] = __any_sync(0xaaaaaaaau, mine);
        all[i] = __all_sync(0xaaaaaaaau, mine);
    } else {
        any[i] = __any_sync(0x55555555u, mine);
        all[i] = __all_sync(0x55555555u, mine);
    }
}

// A sum over the warp in which each half of the lanes takes a path of its own.
__global__ void sums_of_halves(int* out) {
    int lane = threadIdx.x % 32, value = threadIdx.x;
    unsigned mine = lane < 16 ? 0x0000ffffu : 0xffff0000u;
    if (lane < 16) {
        for (int d = 8; d; d /= 2) value += __shfl_xor_sync(mine, value, d);
    } else {
        for (int d = 1; d < 16; d *= 2) value += __shfl_xor_sync(mine, value, d, 16);
        value = -value;
    }
    out[threadIdx.x] = value;
}

// Lanes write, then read their neighbour's word, warp by warp.
__global__ void neighbours(int* out) {
    __shared__ int words[1024];
    int t = threadIdx.x, warp = t / 32 * 32;
    for (int round = 0; round < 4; ++round) {
        words[t] = t * 10 + round;
        __syncwarp();
        out[t] += words[warp + (t + 1) % 32];
        __syncwarp();
    }
}

__global__ void branch_masks(unsigned* masks) {
    int t = threadIdx.x;
    if (t % 3 == 0)
        masks[t] = __activemask();
    else
        masks[t] = __activemask();
}

} // namespace

TEST(Shuffle, BringsTheRightLaneForEveryKindWidthAndType) {
    test_shuffles<int>();
    test_shuffles<unsigned>();
    test_shuffles<long long>();
    test_shuffles<unsigned long long>();
    test_shuffles<float>();
    test_shuffles<double>();
}

TEST(Vote, CountsTheLanesOfTheMaskOnly) {
    for_each_setting([] {
        for (unsigned pattern : {0u, 1u, 0x80000000u, 0x55555555u, 0xaaaaaaaau, 0xffff0000u, ~0u}) {
            DeviceArray<unsigned> ballots(64);
            DeviceArray<int> any(64), all(64);
            votes<<<1, 64>>>(pattern, ballots.data(), any.data(), all.data());
            auto b = ballots.host();
            auto some = any.host(), every = all.host();
            for (int i = 0; i < 64; ++i) {
                unsigned group = i % 2 ? 0xaaaaaaaau : 0x55555555u;
                ASSERT_EQ(b[i], pattern);
                ASSERT_EQ(some[i] != 0, (pattern & group) != 0);
                ASSERT_EQ(every[i] != 0, (pattern & group) == group);
            }
        }
    });
}

TEST(Shuffle, GroupsOfOneWarpDoNotMeet) {
    for_each_setting([] {
        DeviceArray<int> out(64);
        sums_of_halves<<<1, 64>>>(out.data());
        auto got = out.host();
        for (int i = 0; i < 64; ++i) {
            int first = i / 16 * 16, sum = 16 * first + 15 * 16 / 2;
            EXPECT_EQ(got[i], i % 32 < 16 ? sum : -sum);
        }
    });
}

TEST(SyncWarp, OrdersWritesAndReadsOfTheLanes) {
    for_each_setting([] {
        for (int threads : {32, 64, 128}) {
            DeviceArray<int> out(threads);
            neighbours<<<1, threads>>>(out.data());
            auto got = out.host();
            for (int t = 0; t < threads; ++t) {
                int next = t / 32 * 32 + (t + 1) % 32;
                ASSERT_EQ(got[t], 4 * next * 10 + 0 + 1 + 2 + 3);
            }
        }
    });
}

// CUDA promises less: any set of lanes that are there. The caller always belongs to it, and no lane
// of the other branch does.
TEST(ActiveMask, NamesTheCallerAndNobodyOfTheOtherBranch) {
    for_each_setting([] {
        DeviceArray<unsigned> masks(48);
        branch_masks<<<1, 48>>>(masks.data());
        auto got = masks.host();
        for (int t = 0; t < 48; ++t) {
            ASSERT_TRUE(got[t] >> t % 32 & 1);
            for (int lane = 0; lane < 32; ++lane) {
                if (!(got[t] >> lane & 1)) continue;
                int other = t / 32 * 32 + lane;
                EXPECT_LT(other, 48);
                EXPECT_EQ(t % 3 == 0, other % 3 == 0);
            }
        }
    });
}
