// CUB's collectives of a block and a warp, against loops.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <cub/cub.cuh>

#include <vector>

namespace {

constexpr int threads = 96, items = 3;

int brought(int i) { return i * 37 % 101 - 50; }

template <class T> struct OnDevice {
    T* data;
    explicit OnDevice(const std::vector<T>& host) {
        cudaMalloc(&data, host.size() * sizeof(T));
        cudaMemcpy(data, host.data(), host.size() * sizeof(T), cudaMemcpyHostToDevice);
    }
    ~OnDevice() { cudaFree(data); }
    std::vector<T> host(size_t count) const {
        std::vector<T> out(count);
        cudaMemcpy(out.data(), data, count * sizeof(T), cudaMemcpyDeviceToHost);
        return out;
    }
};

std::vector<int> all_brought() {
    std::vector<int> in(threads * items);
    for (int i = 0; i < threads * items; ++i) in[size_t(i)] = brought(i);
    return in;
}

// out: sum, greatest, sum of the first 10, sum of three each
__global__ void reduce(const int* in, int* out) {
    using Reduce = cub::BlockReduce<int, 16, cub::BLOCK_REDUCE_RAKING, 6>;
    __shared__ typename Reduce::TempStorage storage;
    const int t = threadIdx.y * blockDim.x + threadIdx.x;
    const int three[items] = {in[t * items], in[t * items + 1], in[t * items + 2]};
    const int sum = Reduce(storage).Sum(in[t]);
    __syncthreads();
    const int greatest = Reduce(storage).Reduce(in[t], cub::Max());
    __syncthreads();
    const int of_ten = Reduce(storage).Sum(in[t], 10);
    __syncthreads();
    const int of_all = Reduce(storage).Sum(three);
    if (t > 0) return;
    out[0] = sum;
    out[1] = greatest;
    out[2] = of_ten;
    out[3] = of_all;
}

TEST(BlockCollectives, ReduceToTheFirstThread) {
    const OnDevice<int> in(all_brought()), out(std::vector<int>(4));
    reduce<<<1, dim3(16, 6)>>>(in.data, out.data);
    int sum = 0, greatest = brought(0), of_ten = 0, of_all = 0;
    for (int i = 0; i < threads * items; ++i) {
        of_all += brought(i);
        if (i < threads) sum += brought(i);
        if (i < threads) greatest = std::max(greatest, brought(i));
        if (i < 10) of_ten += brought(i);
    }
    EXPECT_EQ(out.host(4), (std::vector<int>{sum, greatest, of_ten, of_all}));
}

// For each thread: inclusive, exclusive from 7 on, the sum of all; then three exclusive ones.
__global__ void scan(const int* in, int* out, int* of_three) {
    using Scan = cub::BlockScan<int, threads>;
    __shared__ typename Scan::TempStorage storage;
    const int t = threadIdx.x;
    int inclusive, exclusive, all;
    Scan(storage).InclusiveSum(in[t], inclusive);
    __syncthreads();
    Scan(storage).ExclusiveScan(in[t], exclusive, 7, cub::Sum(), all);
    __syncthreads();
    int three[items] = {in[t * items], in[t * items + 1], in[t * items + 2]};
    Scan(storage).ExclusiveSum(three, three);
    out[t * 3] = inclusive;
    out[t * 3 + 1] = exclusive;
    out[t * 3 + 2] = all;
    for (int i = 0; i < items; ++i) of_three[t * items + i] = three[i];
}

TEST(BlockCollectives, ScanUpToEachThread) {
    const OnDevice<int> in(all_brought()), out(std::vector<int>(threads * 3)),
        three(std::vector<int>(threads * items));
    scan<<<1, threads>>>(in.data, out.data, three.data);
    std::vector<int> expected(threads * 3), of_three(threads * items);
    int all = 0, running = 0;
    for (int t = 0; t < threads; ++t) all += brought(t);
    for (int t = 0; t < threads; ++t) {
        expected[size_t(t) * 3 + 1] = 7 + running;
        running += brought(t);
        expected[size_t(t) * 3] = running;
        expected[size_t(t) * 3 + 2] = all;
    }
    for (int i = 1; i < threads * items; ++i)
        of_three[size_t(i)] = of_three[size_t(i) - 1] + brought(i - 1);
    EXPECT_EQ(out.host(expected.size()), expected);
    EXPECT_EQ(three.host(of_three.size()), of_three);
}

__global__ void differ(const int* in, int* left, int* right) {
    using Adjacent = cub::BlockAdjacentDifference<int, threads>;
    __shared__ typename Adjacent::TempStorage storage;
    const int t = threadIdx.x;
    int values[items] = {in[t * items], in[t * items + 1], in[t * items + 2]}, to_right[items];
    Adjacent(storage).SubtractRight(values, to_right, cub::Difference());
    __syncthreads();
    Adjacent(storage).SubtractLeft(values, values, cub::Difference()); // in place
    for (int i = 0; i < items; ++i) {
        left[t * items + i] = values[i];
        right[t * items + i] = to_right[i];
    }
}

TEST(BlockCollectives, DifferencesOfNeighbours) {
    const size_t count = threads * items;
    const OnDevice<int> in(all_brought()), right(in.host(count)), to_left(in.host(count));
    differ<<<1, threads>>>(in.data, to_left.data, right.data);
    std::vector<int> of_left = all_brought(), of_right = all_brought();
    for (int i = 0; i + 1 < int(count); ++i) {
        of_left[size_t(i) + 1] = brought(i + 1) - brought(i);
        of_right[size_t(i)] = brought(i) - brought(i + 1);
    }
    EXPECT_EQ(to_left.host(count), of_left);
    EXPECT_EQ(right.host(count), of_right);
}

__global__ void of_warps(const int* in, int* sums, int* running) {
    __shared__ typename cub::WarpReduce<int, 16>::TempStorage reduces[threads / 16];
    __shared__ typename cub::WarpScan<int>::TempStorage scans[threads / 32];
    const int t = threadIdx.x, sum = cub::WarpReduce<int, 16>(reduces[t / 16]).Sum(in[t]);
    if (t % 16 == 0) sums[t / 16] = sum;
    cub::WarpScan<int>(scans[t / 32]).ExclusiveSum(in[t], running[t]);
}

TEST(BlockCollectives, OfWarps) {
    const OnDevice<int> in(all_brought()), sums(std::vector<int>(threads / 16)),
        running(std::vector<int>(threads * items));
    of_warps<<<1, threads>>>(in.data, sums.data, running.data);
    std::vector<int> expected(threads / 16), before(size_t(threads), 0);
    for (int t = 0; t < threads; ++t) {
        expected[size_t(t) / 16] += brought(t);
        if (t % 32) before[size_t(t)] = before[size_t(t) - 1] + brought(t - 1);
    }
    EXPECT_EQ(sums.host(expected.size()), expected);
    EXPECT_EQ(running.host(before.size()), before);
}

} // namespace
