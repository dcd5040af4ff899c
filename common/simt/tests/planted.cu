// A program with one planted mistake at a time, for the sanitizer builds: planted MISTAKE. Each
// must be found on the line that names it (planted.cmake); with `nothing`, nothing may be found.
#include "common/simt/check.h"

#include <cstdio>
#include <cstring>
#include <string>

using namespace raylab;

namespace {

constexpr int threads = 64;

// Each thread reads its right neighbour's word, with or without waiting for it to be written.
__global__ void neighbour(int* out, bool wait) {
    __shared__ int words[threads];
    words[threadIdx.x] = threadIdx.x;
    if (wait) __syncthreads();
    out[threadIdx.x] = words[(threadIdx.x + 1) % threads]; // MISTAKE missing_barrier
}

// The words are written again while slower threads may still read them.
__global__ void reuse(int* out, bool wait) {
    __shared__ int words[threads];
    for (int round = 0; round < 2; ++round) {
        words[threadIdx.x] = round; // MISTAKE missing_second_barrier
        __syncthreads();
        out[threadIdx.x] += words[(threadIdx.x + 1) % threads];
        if (wait) __syncthreads();
    }
}

// The same within a warp.
__global__ void neighbour_lane(int* out, bool wait) {
    __shared__ int words[32];
    words[threadIdx.x] = threadIdx.x;
    if (wait) __syncwarp();
    out[threadIdx.x] = words[threadIdx.x ^ 1]; // MISTAKE missing_syncwarp
}

__global__ void count(int* total, bool atomic) {
    if (atomic)
        atomicAdd(total, 1);
    else if (threadIdx.x == 0)
        *total += 1; // MISTAKE race_of_blocks
}

__global__ void scratch(int* out, int n) {
    __shared__ int words[threads];
    __shared__ int after[threads];
    after[threadIdx.x] = 1;
    int* volatile word = words + threadIdx.x; // hidden from the compiler, which has its own checks
    word[n] = 1;                              // MISTAKE shared_overrun
    out[threadIdx.x] = words[threadIdx.x] + after[threadIdx.x];
}

__global__ void dynamic(int* out, int n) {
    extern __shared__ int words[];
    words[threadIdx.x + n] = 1; // MISTAKE dynamic_overrun
    __syncthreads();
    out[threadIdx.x] = words[threadIdx.x];
}

struct View {
    int* data;
};
__global__ void write(View view, int n) {
    view.data[threadIdx.x + n] = 1; // MISTAKE overrun
}
__global__ void write_freed(View view) {
    view.data[threadIdx.x] = 1; // MISTAKE use_after_free
}

int run(const std::string& mistake) {
    auto made = [&](const char* name) { return mistake == name; };
    int *out = nullptr, *lost = nullptr, host[threads] = {};
    simt::check(cudaMalloc(&out, sizeof host), "cudaMalloc");
    simt::check(cudaMemset(out, 0, sizeof host), "cudaMemset");
    neighbour<<<1, threads>>>(out, !made("missing_barrier"));
    simt::check(cudaMemset(out, 0, sizeof host), "cudaMemset");
    reuse<<<1, threads>>>(out, !made("missing_second_barrier"));
    neighbour_lane<<<1, 32>>>(out, !made("missing_syncwarp"));
    count<<<3, threads>>>(out, !made("race_of_blocks"));
    scratch<<<1, threads>>>(out, made("shared_overrun"));
    dynamic<<<1, threads, sizeof host>>>(out, made("dynamic_overrun"));
    write<<<1, threads>>>({out}, made("overrun"));
    simt::check(cudaMemcpy(host, out, sizeof host, cudaMemcpyDeviceToHost), "cudaMemcpy");
    if (made("host_dereference")) host[0] += out[3];                    // MISTAKE host_dereference
    if (made("leak")) simt::check(cudaMalloc(&lost, 12), "cudaMalloc"); // MISTAKE leak
    simt::check(cudaFree(out), "cudaFree");
    if (made("use_after_free")) write_freed<<<1, threads>>>({out});
    std::printf("done: %d\n", host[0]);
    return 0;
}

} // namespace

int main(int argc, char** argv) { return run(argc > 1 ? argv[1] : "nothing"); }
