// What is the CPU machine's own: its orders of turns really differ, every block runs once, stacks
// are as large as asked, and a kernel that waits costs nobody else anything.
#include "common/simt/tests/settings.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <thread>

using namespace raylab::simt;

namespace {

__global__ void record(int* next, int* turns) {
    turns[atomicAdd(next, 1)] = blockIdx.x * blockDim.x + threadIdx.x;
}

__global__ void record_after_barrier(int* next, int* turns) {
    __syncthreads();
    turns[atomicAdd(next, 1)] = threadIdx.x;
}

// The threads of a launch in the order in which they ran.
std::vector<int> turns(Options options, bool barrier, int blocks, int threads) {
    options.threads = 1;
    set_options(options);
    DeviceArray<int> next(1), turns(blocks * threads, -1);
    if (barrier)
        record_after_barrier<<<blocks, threads>>>(next.data(), turns.data());
    else
        record<<<blocks, threads>>>(next.data(), turns.data());
    set_options({});
    return turns.host();
}

__global__ void visit(unsigned* visits) {
    if (threadIdx.x == 0) atomicAdd(&visits[blockIdx.y * gridDim.x + blockIdx.x], 1u);
}

// Uses about `bytes` of stack, in the frame where it waits.
template <int bytes> __global__ void deep(int* out) {
    volatile char frame[bytes];
    for (int i = 0; i < bytes; i += 512) frame[i] = char(threadIdx.x);
    __syncthreads();
    int sum = 0;
    for (int i = 0; i < bytes; i += 512) sum += frame[i];
    out[threadIdx.x] = sum;
}

__global__ void increment(int* p) { atomicAdd(p, 1); }

} // namespace

TEST(Machine, TakesTurnsInTheOrderThatWasAskedFor) {
    std::vector<int> forward(40);
    std::iota(forward.begin(), forward.end(), 0);
    std::vector<int> reverse(forward.rbegin(), forward.rend());
    for (bool barrier : {false, true}) {
        int blocks = barrier ? 1 : 2, threads = 40 / blocks;
        EXPECT_EQ(turns({.order = Order::forward}, barrier, blocks, threads), forward);
        EXPECT_EQ(turns({.order = Order::reverse}, barrier, blocks, threads), reverse);
        std::set<std::vector<int>> seen;
        for (uint64_t seed : {1, 2, 3}) {
            auto random = turns({.order = Order::random, .seed = seed}, barrier, blocks, threads);
            EXPECT_EQ(random,
                      turns({.order = Order::random, .seed = seed}, barrier, blocks, threads));
            seen.insert(random);
            std::sort(random.begin(), random.end());
            EXPECT_EQ(random, forward); // everybody has one turn
        }
        EXPECT_EQ(seen.size(), 3u) << "the seed changes nothing";
        EXPECT_FALSE(seen.count(forward));
    }
}

__global__ void record_around_barrier(int* next, int* before, int* after) {
    before[atomicAdd(&next[0], 1)] = threadIdx.x;
    __syncthreads();
    after[atomicAdd(&next[1], 1)] = threadIdx.x;
}

TEST(Machine, MixesTheTurnsAnewAtEachBarrier) {
    set_options({.threads = 1, .order = Order::random});
    DeviceArray<int> next(2), before(64), after(64);
    record_around_barrier<<<1, 64>>>(next.data(), before.data(), after.data());
    EXPECT_NE(before.host(), after.host());
    set_options({});
}

TEST(Machine, RunsEveryBlockOnce) {
    for_each_setting([] {
        for (dim3 grid : {dim3(1), dim3(2), dim3(97), dim3(64, 3), dim3(30, 17)}) {
            DeviceArray<unsigned> visits(grid.x * grid.y);
            visit<<<grid, 2>>>(visits.data());
            for (unsigned n : visits.host()) ASSERT_EQ(n, 1u);
        }
    });
}

TEST(Machine, GivesWaitingThreadsTheStackThatWasAskedFor) {
    constexpr int bytes = 400 << 10;
    set_options({.stack_size = 512 << 10});
    DeviceArray<int> out(8);
    deep<bytes><<<1, 8>>>(out.data());
    auto got = out.host();
    for (int t = 0; t < 8; ++t) EXPECT_EQ(got[t], t * (bytes / 512));
    set_options({});
}

TEST(Machine, MayBeUsedFromSeveralHostThreads) {
    DeviceArray<int> out(1);
    std::vector<std::thread> hosts;
    for (int host = 0; host < 4; ++host)
        hosts.emplace_back([&] {
            for (int i = 0; i < 20; ++i) increment<<<4, 8>>>(out.data());
        });
    for (auto& host : hosts) host.join();
    EXPECT_EQ(out.host()[0], 4 * 20 * 4 * 8);
}
