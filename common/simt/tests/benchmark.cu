// What the CPU machine costs: nanoseconds of one processor for each thread, barrier and launch. A
// plain program, to be run by hand on a quiet machine.
#include "common/simt/check.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace raylab;

namespace {

__global__ void nothing(int) {}

__global__ void barriers(int count) {
    for (int i = 0; i < count; ++i) __syncthreads();
}

__global__ void shuffles(int count, int* out) {
    int value = threadIdx.x;
    for (int i = 0; i < count; ++i) value = __shfl_xor_sync(0xffffffffu, value, 1);
    if (value < 0) *out = value;
}

// Processor time of the calling thread, in nanoseconds: others on the machine do not count.
double now() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e9 + double(time.tv_nsec);
}

// The best of several runs of `work`.
template <class Work> double best(Work work) {
    double least = 1e300;
    for (int run = 0; run < 7; ++run) {
        double start = now();
        work();
        least = std::min(least, now() - start);
    }
    simt::check(cudaDeviceSynchronize(), "benchmark");
    return least;
}

} // namespace

int main() {
    simt::set_options({.threads = 1});
    std::printf("launch of one thread       %8.1f ns\n", best([] {
                                                             for (int i = 0; i < 10000; ++i)
                                                                 nothing<<<1, 1>>>(i);
                                                         }) / 10000);
    std::printf("empty block of 64 threads  %8.1f ns\n",
                best([] { nothing<<<10000, 64>>>(0); }) / 10000);
    std::printf("thread, blocks of 256      %8.2f ns\n",
                best([] { nothing<<<10000, 256>>>(0); }) / 10000 / 256);
    for (int size : {32, 64, 128, 256, 512, 1024})
        std::printf("barrier, blocks of %4d    %8.1f ns a thread\n", size,
                    best([=] { barriers<<<1, size>>>(1000); }) / 1000 / size);
    for (int size : {32, 256, 1024})
        std::printf("shuffle, blocks of %4d    %8.1f ns a thread\n", size,
                    best([=] { shuffles<<<1, size>>>(1000, 0); }) / 1000 / size);
}
