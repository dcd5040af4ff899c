// Kernels whose threads work together give the right result for every block size, order of turns
// and number of workers.
#include "common/simt/tests/settings.h"

#include <numeric>

using namespace raylab::simt;

namespace {

// Sum of a block by halving, for any block size.
__global__ void reduce(const int* in, int* out, int n) {
    extern __shared__ int partial[];
    int t = threadIdx.x, i = blockIdx.x * blockDim.x + t;
    partial[t] = i < n ? in[i] : 0;
    __syncthreads();
    for (int count = blockDim.x; count > 1;) {
        int half = (count + 1) / 2;
        if (t + half < count) partial[t] += partial[t + half];
        count = half;
        __syncthreads();
    }
    if (t == 0) out[blockIdx.x] = partial[0];
}

// Inclusive scan of a block (Hillis and Steele), with two buffers.
__global__ void scan(const int* in, int* out) {
    __shared__ int words[2][1024];
    int t = threadIdx.x, from = 0;
    words[0][t] = in[blockIdx.x * blockDim.x + t];
    for (int step = 1; step < blockDim.x; step *= 2) {
        __syncthreads();
        words[1 - from][t] = words[from][t] + (t >= step ? words[from][t - step] : 0);
        from = 1 - from;
    }
    out[blockIdx.x * blockDim.x + t] = words[from][t];
}

// Each block counts in shared memory, and adds its counts to the total.
__global__ void histogram(const int* in, int n, unsigned* total) {
    __shared__ unsigned counts[16];
    for (int i = threadIdx.x; i < 16; i += blockDim.x) counts[i] = 0;
    __syncthreads();
    for (int i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += gridDim.x * blockDim.x)
        atomicAdd(&counts[in[i] & 15], 1u);
    __syncthreads();
    for (int i = threadIdx.x; i < 16; i += blockDim.x) atomicAdd(&total[i], counts[i]);
}

// The last block to finish adds up what the others left (threadFenceReduction of the samples).
__global__ void reduce_in_one_launch(const int* in, int* partial, unsigned* ticket, int* out) {
    __shared__ int sum;
    __shared__ bool last;
    if (threadIdx.x == 0) sum = 0;
    __syncthreads();
    atomicAdd(&sum, in[blockIdx.x * blockDim.x + threadIdx.x]);
    __syncthreads();
    if (threadIdx.x == 0) {
        partial[blockIdx.x] = sum;
        __threadfence();
        last = atomicInc(ticket, gridDim.x - 1) == gridDim.x - 1;
    }
    __syncthreads();
    if (last && threadIdx.x == 0)
        for (int b = 0; b < gridDim.x; ++b) *out += partial[b];
}

__global__ void barrier_votes(int period, int* count, int* some, int* every) {
    int t = threadIdx.x, yes = t % period == 0 ? 5 : 0;
    count[t] = __syncthreads_count(yes);
    some[t] = __syncthreads_or(t == 3 ? yes : 0);
    every[t] = __syncthreads_and(yes);
}

// More values of each kind than registers that a function keeps for its caller.
__global__ void count_on(long long* whole, double* real) {
    long long i[12];
    double x[10];
    for (int k = 0; k < 12; ++k) i[k] = threadIdx.x * 1000 + k;
    for (int k = 0; k < 10; ++k) x[k] = threadIdx.x * 100 + k;
    for (int round = 0; round < 3; ++round) {
        __syncthreads();
        for (int k = 0; k < 12; ++k) i[k] = i[k] * 3 + 1;
        for (int k = 0; k < 10; ++k) x[k] = x[k] * 2 + 1;
    }
    for (int k = 0; k < 12; ++k) whole[threadIdx.x] += i[k] << k;
    for (int k = 0; k < 10; ++k) real[threadIdx.x] += x[k] * (1 << k);
}

std::vector<int> numbers(int n) {
    std::vector<int> values(n);
    for (int i = 0; i < n; ++i) values[i] = int(unsigned(i) * 2654435761u >> 20) - 2000;
    return values;
}

} // namespace

TEST(Cooperation, ReductionIsTheSum) {
    for_each_setting([] {
        for (int size : block_sizes) {
            constexpr int blocks = 5;
            auto in = numbers(blocks * size - size / 2);
            DeviceArray<int> device_in(in), out(blocks);
            reduce<<<blocks, size, size * sizeof(int)>>>(device_in.data(), out.data(),
                                                         int(in.size()));
            auto got = out.host();
            ASSERT_EQ(std::accumulate(got.begin(), got.end(), 0),
                      std::accumulate(in.begin(), in.end(), 0))
                << size;
        }
    });
}

TEST(Cooperation, ScanIsThePrefixSum) {
    for_each_setting([] {
        for (int size : block_sizes) {
            auto in = numbers(3 * size);
            DeviceArray<int> device_in(in), out(in.size());
            scan<<<3, size>>>(device_in.data(), out.data());
            auto got = out.host();
            for (int block = 0; block < 3; ++block)
                for (int t = 0, sum = 0; t < size; ++t)
                    ASSERT_EQ(got[block * size + t], sum += in[block * size + t]) << size;
        }
    });
}

TEST(Cooperation, HistogramCountsEachNumberOnce) {
    for_each_setting([] {
        auto in = numbers(10007);
        std::vector<unsigned> want(16);
        for (int value : in) ++want[value & 15];
        DeviceArray<int> device_in(in);
        for (int size : block_sizes) {
            DeviceArray<unsigned> total(16);
            histogram<<<4, size>>>(device_in.data(), int(in.size()), total.data());
            ASSERT_EQ(total.host(), want) << size;
        }
    });
}

TEST(Cooperation, TheLastBlockSeesTheOthers) {
    for_each_setting([] {
        auto in = numbers(24 * 64);
        DeviceArray<int> device_in(in), partial(24), out(1);
        DeviceArray<unsigned> ticket(1);
        reduce_in_one_launch<<<24, 64>>>(device_in.data(), partial.data(), ticket.data(),
                                         out.data());
        EXPECT_EQ(out.host()[0], std::accumulate(in.begin(), in.end(), 0));
    });
}

TEST(Cooperation, ABarrierKeepsWhatItsThreadsHold) {
    constexpr int threads = 64;
    std::vector<long long> whole(threads);
    std::vector<double> real(threads);
    for (int t = 0; t < threads; ++t) { // three times 3 i + 1, and three times 2 x + 1
        for (int k = 0; k < 12; ++k) whole[size_t(t)] += (27 * (t * 1000 + k) + 13LL) << k;
        for (int k = 0; k < 10; ++k) real[size_t(t)] += (8 * (t * 100 + k) + 7) * (1 << k);
    }
    for_each_setting([&] {
        DeviceArray<long long> found_whole(threads);
        DeviceArray<double> found_real(threads);
        count_on<<<1, threads>>>(found_whole.data(), found_real.data());
        EXPECT_EQ(found_whole.host(), whole);
        EXPECT_EQ(found_real.host(), real);
    });
}

TEST(Cooperation, BarriersCountAndVote) {
    for_each_setting([] {
        for (int size : block_sizes)
            for (int period : {1, 2, 3, 2000}) {
                DeviceArray<int> count(size), some(size), every(size);
                barrier_votes<<<1, size>>>(period, count.data(), some.data(), every.data());
                auto c = count.host(), s = some.host(), e = every.host();
                for (int t = 0; t < size; ++t) {
                    ASSERT_EQ(c[t], (size + period - 1) / period);
                    ASSERT_EQ(s[t] != 0, size > 3 && 3 % period == 0);
                    ASSERT_EQ(e[t] != 0, period == 1 || size == 1);
                }
            }
    });
}
