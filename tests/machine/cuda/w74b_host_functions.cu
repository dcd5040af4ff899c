// expect: host error 16 host-function; host error 18 host-variable; host error 12 host-variable
#include <cuda_runtime.h>
#include <algorithm>
#include <cstdio>

float gain = 2;
const int width = 4; // an integral constant is no memory
constexpr float offset = 1;
static int square(int x) { return x * x; }
template <class T> __host__ __device__ T twice(T x) { return x + x; }

__device__ float scaled(float x) { return gain * x; } // BUG

__global__ void k(float* out) {
    const auto half = [](float x) { return x / 2; };
    out[threadIdx.x] = square(threadIdx.x) + offset; // BUG
    out[threadIdx.x] += twice(width) + half(3);
    out[threadIdx.x] += scaled(1) + (threadIdx.x == 0 ? gain : 0); // BUG
}

int main() {
    float* out;
    cudaMalloc(&out, 4 * sizeof(float));
    k<<<1, 4>>>(out);
    float h[4];
    cudaMemcpy(h, out, sizeof h, cudaMemcpyDeviceToHost);
    std::sort(h, h + 4);
    printf("%g %d\n", twice(h[3]), square(3));
    cudaFree(out);
}
