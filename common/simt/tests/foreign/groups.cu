// Cooperative groups, against what the programming guide says each member gets.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <cooperative_groups.h>
#include <cooperative_groups/memcpy_async.h>
#include <cooperative_groups/reduce.h>
#include <cooperative_groups/scan.h>

#include <bit>

namespace cg = cooperative_groups;

namespace {

// The reduction of the programming guide, for any group.
__device__ int sum_of_group(cg::thread_group group, int* scratch, int value) {
    int lane = int(group.thread_rank());
    for (int i = int(group.size()) / 2; i > 0; i /= 2) {
        scratch[lane] = value;
        group.sync();
        if (lane < i) value += scratch[lane + i];
        group.sync();
    }
    return value;
}

__global__ void sums(int* of_block, int* of_tiles) {
    extern __shared__ int scratch[];
    auto block = cg::this_thread_block();
    int sum = sum_of_group(block, scratch, int(block.thread_rank()));
    if (block.thread_rank() == 0) *of_block = sum;
    cg::sync(block);
    auto tile = cg::tiled_partition(block, 4);
    int* mine = scratch + block.thread_rank() / 4 * 4;
    sum = sum_of_group(tile, mine, int(block.thread_rank()));
    if (tile.thread_rank() == 0) of_tiles[block.thread_rank() / 4] = sum;
}

struct Tile {
    unsigned rank, part, parts, ballot, same;
    int shuffled, up, down, exchanged, any, all, sum, smallest, running, before;
};

template <unsigned Size> __global__ void tiles(Tile* out) {
    auto block = cg::this_thread_block();
    auto tile = cg::tiled_partition<Size>(block);
    int t = int(block.thread_rank());
    Tile result{};
    cg::thread_block_tile<Size> of_any_parent = tile;
    result.rank = of_any_parent.thread_rank();
    result.part = tile.meta_group_rank();
    result.parts = tile.meta_group_size();
    result.ballot = tile.ballot(t % 3 == 0);
    result.same = tile.match_any(t / 3);
    result.shuffled = tile.shfl(t, Size - 1);
    result.up = tile.shfl_up(t, 1);
    result.down = tile.shfl_down(t, 2);
    result.exchanged = tile.shfl_xor(t, Size / 2);
    result.any = tile.any(t == 5);
    result.all = tile.all(t < 64);
    result.sum = cg::reduce(tile, t, cg::plus<int>());
    result.smallest = cg::reduce(tile, -t, cg::less<int>());
    result.running = cg::inclusive_scan(tile, t, cg::plus<int>());
    result.before = cg::exclusive_scan(tile, t);
    out[t] = result;
}

template <unsigned Size> void test_tiles() {
    DeviceArray<Tile> out(96);
    tiles<Size><<<1, 96>>>(out.data());
    auto got = out.host();
    for (int t = 0; t < 96; ++t) {
        SCOPED_TRACE(testing::Message() << "size " << Size << ", thread " << t);
        int size = int(Size), rank = t % size, first = t - rank, last = first + size - 1;
        unsigned ballot = 0, same = 0;
        for (int other = first; other <= last; ++other) {
            ballot |= unsigned(other % 3 == 0) << (other - first);
            same |= unsigned(other / 3 == t / 3) << (other - first);
        }
        ASSERT_EQ(got[t].rank, unsigned(rank));
        ASSERT_EQ(got[t].part, unsigned(t / size));
        ASSERT_EQ(got[t].parts, 96 / Size);
        ASSERT_EQ(got[t].ballot, ballot);
        ASSERT_EQ(got[t].same, same);
        ASSERT_EQ(got[t].shuffled, last);
        ASSERT_EQ(got[t].up, rank ? t - 1 : t);
        ASSERT_EQ(got[t].down, t + 2 <= last ? t + 2 : t);
        ASSERT_EQ(got[t].exchanged, first + (rank ^ size / 2));
        ASSERT_EQ(got[t].any != 0, first <= 5 && 5 <= last);
        ASSERT_EQ(got[t].all != 0, last < 64);
        ASSERT_EQ(got[t].sum, size * (first + last) / 2);
        ASSERT_EQ(got[t].smallest, -last);
        ASSERT_EQ(got[t].running, (rank + 1) * (first + t) / 2);
        ASSERT_EQ(got[t].before, (rank + 1) * (first + t) / 2 - t);
    }
}

// Aggregates an atomic over the lanes that take the branch, as the guide does.
__global__ void aggregate(int* counter, int* slots, int every) {
    if (threadIdx.x % every) return;
    auto active = cg::coalesced_threads();
    int base = 0;
    if (active.thread_rank() == 0) base = atomicAdd(counter, int(active.size()));
    base = active.shfl(base, 0);
    slots[base + active.thread_rank()] = int(threadIdx.x);
}

struct Wide {
    double a, b, c;
};

__global__ void odd_things(double* out) {
    auto warp = cg::tiled_partition<32>(cg::this_thread_block());
    double t = threadIdx.x;
    Wide wide = warp.shfl(Wide{t, t * 2, t * 3}, 7);
    auto thirds = cg::labeled_partition(warp, threadIdx.x % 3);
    double sum = cg::reduce(thirds, t, [](double a, double b) { return a + b; });
    auto eighth = cg::tiled_partition<8>(warp);
    auto pairs = cg::tiled_partition(thirds, 2);
    out[threadIdx.x] =
        wide.a + wide.b + wide.c + sum * 100 + eighth.meta_group_rank() * 1e6 + pairs.size() * 1e7;
}

__global__ void copies(const int* in, int* out, int n) {
    extern __shared__ int stage[];
    auto block = cg::this_thread_block();
    cg::memcpy_async(block, stage, in, sizeof(int) * n);
    cg::wait(block);
    for (int i = threadIdx.x; i < n; i += blockDim.x) out[i] = stage[n - 1 - i];
}

// Each block adds its left neighbour's value of the round before, round by round.
__global__ void rounds(int* values, int* sums, int count) {
    auto grid = cg::this_grid();
    __shared__ int mine;
    for (int round = 0; round < count; ++round) {
        if (threadIdx.x == 0) mine = values[(blockIdx.x + gridDim.x - 1) % gridDim.x];
        grid.sync();
        if (threadIdx.x == 0) values[blockIdx.x] += mine;
        grid.sync();
    }
    if (grid.thread_rank() == grid.size() - 1)
        for (unsigned b = 0; b < grid.num_blocks(); ++b) *sums += values[b];
}

__global__ void one_block_leaves() {
    if (blockIdx.x == 1) return;
    cg::this_grid().sync();
}

} // namespace

TEST(Groups, AFunctionTakesAnyGroup) {
    for_each_setting([] {
        DeviceArray<int> block(1), parts(16);
        sums<<<1, 64, 64 * sizeof(int)>>>(block.data(), parts.data());
        EXPECT_EQ(block.host()[0], 63 * 64 / 2);
        auto got = parts.host();
        for (int i = 0; i < 16; ++i) EXPECT_EQ(got[i], 16 * i + 6);
    });
}

TEST(Groups, TilesExchangeAndCombine) {
    for_each_setting([] {
        test_tiles<2>();
        test_tiles<4>();
        test_tiles<8>();
        test_tiles<16>();
        test_tiles<32>();
    });
}

TEST(Groups, CoalescedThreadsAreThoseOfTheBranch) {
    for_each_setting([] {
        for (int every : {1, 2, 5, 31}) {
            DeviceArray<int> counter(1), slots(64, -1);
            aggregate<<<1, 64>>>(counter.data(), slots.data(), every);
            int count = 63 / every + 1;
            ASSERT_EQ(counter.host()[0], count);
            auto got = slots.host();
            std::sort(got.begin(), got.begin() + count);
            for (int i = 0; i < count; ++i) ASSERT_EQ(got[i], i * every);
        }
    });
}

TEST(Groups, PartsOfPartsAndLargeValues) {
    DeviceArray<double> out(32);
    odd_things<<<1, 32>>>(out.data());
    auto got = out.host();
    for (int t = 0; t < 32; ++t) {
        double sum = 0;
        int count = 0, rank = t / 3;
        for (int other = t % 3; other < 32; other += 3) sum += other, ++count;
        int pair = rank / 2 * 2 + 2 <= count ? 2 : 1;
        EXPECT_EQ(got[t], 7 * 6 + sum * 100 + t / 8 * 1e6 + pair * 1e7);
    }
}

TEST(Groups, CopyTogether) {
    std::vector<int> in(50);
    for (int i = 0; i < 50; ++i) in[i] = i;
    DeviceArray<int> from(in), to(50);
    copies<<<1, 32, 200>>>(from.data(), to.data(), 50);
    auto got = to.host();
    for (int i = 0; i < 50; ++i) EXPECT_EQ(got[i], 49 - i);
}

TEST(Groups, AGridWaitsForAllItsBlocks) {
    cudaDeviceProp properties;
    ASSERT_EQ(cudaGetDeviceProperties(&properties, 0), cudaSuccess);
    int blocks = properties.cooperativeLaunch ? 7 : 1;
    DeviceArray<int> values(blocks, 1), sums(1);
    int *v = values.data(), *s = sums.data(), count = 5;
    void* arguments[] = {&v, &s, &count};
    ASSERT_EQ(cudaLaunchCooperativeKernel((void*)rounds, dim3(blocks), dim3(40), arguments, 0, 0),
              cudaSuccess);
    EXPECT_EQ(sums.host()[0], blocks * 32); // each round doubles
}

TEST(Groups, AGridThatCannotWaitIsAFault) {
    set_options({.print_reports = false});
    one_block_leaves<<<1, 32>>>();
    EXPECT_EQ(cudaDeviceSynchronize(), cudaErrorLaunchFailure);
    EXPECT_NE(last_report().find("grid.sync() in a launch that is not cooperative"),
              std::string::npos);
    cudaDeviceReset();
    cudaDeviceProp properties;
    ASSERT_EQ(cudaGetDeviceProperties(&properties, 0), cudaSuccess);
    if (properties.cooperativeLaunch) {
        EXPECT_NE(cudaLaunchCooperativeKernel(one_block_leaves, 3, 32, nullptr), cudaSuccess);
        EXPECT_NE(last_report().find("a block has returned"), std::string::npos);
        EXPECT_NE(last_report().find("kernel one_block_leaves"), std::string::npos);
        cudaDeviceReset();
    }
    EXPECT_EQ(cudaLaunchCooperativeKernel(one_block_leaves, 100000, 32, nullptr),
              cudaErrorCooperativeLaunchTooLarge);
    cudaGetLastError();
    set_options({});
}
