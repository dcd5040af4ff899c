// What the CPU machine costs: nanoseconds of one processor for each thread, barrier and launch. A
// plain program, to be run by hand on a quiet machine.
#include "common/simt/check.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

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

// A small path tracer: mirrors and diffuse spheres under a sky, 8 bounces. Its paths differ in
// length, as real ones do.
struct Path {
    float ox, oy, oz, dx, dy, dz, weight;
    unsigned state;
};

__host__ __device__ inline float uniform(unsigned& state) {
    state = state * 747796405u + 2891336453u;
    unsigned word = ((state >> (state >> 28 & 15)) ^ state) * 277803737u;
    return float(word >> 8) * 0x1p-24f;
}

__host__ __device__ inline float radiance(int pixel) {
    Path p{0,
           0,
           -6,
           float(pixel % 256) / 128 - 1,
           float(pixel / 256) / 128 - 1,
           2,
           1,
           unsigned(pixel)};
    for (int bounce = 0; bounce < 8; ++bounce) {
        float nearest = 1e30f, nx = 0, ny = 0, nz = 0;
        float length = sqrtf(p.dx * p.dx + p.dy * p.dy + p.dz * p.dz);
        p.dx /= length, p.dy /= length, p.dz /= length;
        for (int i = 0; i < 9; ++i) {
            float cx = float(i % 3) * 2 - 2, cy = float(i / 3) * 2 - 2, cz = float(i % 2);
            float x = p.ox - cx, y = p.oy - cy, z = p.oz - cz;
            float b = x * p.dx + y * p.dy + z * p.dz, c = x * x + y * y + z * z - 0.9f;
            float root = b * b - c;
            if (root < 0) continue;
            float t = -b - sqrtf(root);
            if (t < 1e-3f || t > nearest) continue;
            nearest = t, nx = x + t * p.dx, ny = y + t * p.dy, nz = z + t * p.dz;
        }
        if (nearest == 1e30f) return p.weight * (1 + p.dy);
        p.ox += nearest * p.dx, p.oy += nearest * p.dy, p.oz += nearest * p.dz;
        float cosine = 2 * (p.dx * nx + p.dy * ny + p.dz * nz) / 0.9f;
        p.dx -= cosine * nx, p.dy -= cosine * ny, p.dz -= cosine * nz;
        p.dx += uniform(p.state) - 0.5f, p.dy += uniform(p.state) - 0.5f;
        p.weight *= 0.8f;
    }
    return 0;
}

__global__ void render(float* image, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) image[i] = radiance(i);
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

// The kernel and a plain loop over the same function, in turns.
void compare_with_a_loop() {
    constexpr int n = 256 * 256;
    float* image = nullptr;
    std::vector<float> host(n);
    simt::check(cudaMalloc(&image, n * sizeof(float)), "cudaMalloc");
    double kernel = 1e300, loop = 1e300;
    for (int round = 0; round < 5; ++round) {
        kernel = std::min(kernel, best([=] { render<<<n / 64, 64>>>(image, n); }));
        loop = std::min(loop, best([&] {
                            for (int i = 0; i < n; ++i) host[i] = radiance(i);
                        }));
    }
    std::vector<float> rendered(n);
    simt::check(cudaMemcpy(rendered.data(), image, n * sizeof(float), cudaMemcpyDeviceToHost),
                "cudaMemcpy");
    simt::check(cudaFree(image), "cudaFree");
    std::printf("path tracing, 64 threads   %8.1f ns a pixel, plain loop %.1f ns: %.3f of it, %s\n",
                kernel / n, loop / n, kernel / loop, rendered == host ? "same bits" : "DIFFERENT");
}

} // namespace

int main() {
    simt::set_options({.threads = 1});
    compare_with_a_loop();
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
