// Atomics: many threads on few words, against the same operations done one after the other. Every
// operation here gives the same final word in any order.
#include "common/simt/tests/settings.h"

#include <algorithm>
#include <numeric>

using namespace raylab::simt;

namespace {

constexpr int threads = 64, blocks = 8, n = threads * blocks;

__host__ __device__ unsigned value_of(int i) { return unsigned(i) * 2654435761u; }

template <class T> struct Words { T add, min, max, bit_and, bit_or, bit_xor, cas; };

template <class T> __global__ void integer_atomics(Words<T>* w) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    T value = T(value_of(i));
    atomicAdd(&w->add, value);
    atomicMin(&w->min, value);
    atomicMax(&w->max, value);
    atomicAnd(&w->bit_and, T(value | 0xf0));
    atomicOr(&w->bit_or, T(value & 0x0ff0));
    atomicXor(&w->bit_xor, value);
    for (T old = 0, seen;; old = seen) // the guide's way to make any atomic: here an addition
        if ((seen = atomicCAS(&w->cas, old, T((unsigned long long)old + value))) == old) break;
}

template <class T> void test_integers() {
    Words<T> start{5, T(~0u >> 1), 0, T(~T(0)), 0, 1, 3}, want = start;
    for (int i = 0; i < n; ++i) {
        T value = T(value_of(i));
        want.add = T((unsigned long long)want.add + (unsigned long long)value);
        want.min = std::min(want.min, value);
        want.max = std::max(want.max, value);
        want.bit_and &= T(value | 0xf0);
        want.bit_or |= T(value & 0x0ff0);
        want.bit_xor ^= value;
        want.cas = T((unsigned long long)want.cas + (unsigned long long)value);
    }
    for_each_setting([&] {
        DeviceArray<Words<T>> words(1, start);
        integer_atomics<<<blocks, threads>>>(words.data());
        auto got = words.host()[0];
        EXPECT_EQ(got.add, want.add);
        EXPECT_EQ(got.min, want.min);
        EXPECT_EQ(got.max, want.max);
        EXPECT_EQ(got.bit_and, want.bit_and);
        EXPECT_EQ(got.bit_or, want.bit_or);
        EXPECT_EQ(got.bit_xor, want.bit_xor);
        EXPECT_EQ(got.cas, want.cas);
    });
}

// Small integers and halves are exact in floating point, in any order.
__global__ void float_atomics(float* f, double* d) {
    atomicAdd(f, float(threadIdx.x) * 0.5f);
    atomicAdd(d, double(threadIdx.x) * 0.5);
}

// Every thread's ticket is what it found: all are different.
__global__ void tickets(unsigned* counters, unsigned* inc, unsigned* dec, unsigned* sub) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    inc[i] = atomicInc(&counters[0], n - 1);
    dec[i] = atomicDec(&counters[1], n - 1);
    sub[i] = atomicSub(&counters[2], 1u);
}

// A list in which each thread hangs itself before the latest one.
__global__ void chain(int* head, int* next) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    next[i] = atomicExch(head, i);
}

} // namespace

TEST(Atomics, OfIntegersGiveTheSequentialResult) {
    test_integers<int>();
    test_integers<unsigned>();
    test_integers<unsigned long long>();
}

TEST(Atomics, OfFloatsLoseNoAddition) {
    for_each_setting([] {
        DeviceArray<float> f(1);
        DeviceArray<double> d(1);
        float_atomics<<<blocks, threads>>>(f.data(), d.data());
        double want = blocks * (threads * (threads - 1) / 2) * 0.5;
        EXPECT_EQ(f.host()[0], want);
        EXPECT_EQ(d.host()[0], want);
    });
}

TEST(Atomics, ReturnWhatTheyFound) {
    for_each_setting([] {
        DeviceArray<unsigned> counters(std::vector<unsigned>{0, n + 5, n}), inc(n), dec(n), sub(n);
        tickets<<<blocks, threads>>>(counters.data(), inc.data(), dec.data(), sub.data());
        std::vector<unsigned> up(n), down(n);
        std::iota(up.begin(), up.end(), 0u);
        std::iota(down.begin(), down.end(), 1u);
        auto got = inc.host();
        std::sort(got.begin(), got.end());
        EXPECT_EQ(got, up);
        got = sub.host();
        std::sort(got.begin(), got.end());
        EXPECT_EQ(got, down);
        // From above the limit down: n + 5, then n - 1, ..., 1.
        got = dec.host();
        std::sort(got.begin(), got.end());
        down.back() = n + 5;
        EXPECT_EQ(got, down);
        EXPECT_EQ(counters.host(), (std::vector<unsigned>{0, 0, 0}));
    });
}

TEST(Atomics, ExchangeLosesNobody) {
    for_each_setting([] {
        DeviceArray<int> head(1, -1), next(n);
        chain<<<blocks, threads>>>(head.data(), next.data());
        auto after = next.host();
        int length = 0;
        for (int i = head.host()[0]; i >= 0 && length <= n; i = after[i]) ++length;
        EXPECT_EQ(length, n);
    });
}
