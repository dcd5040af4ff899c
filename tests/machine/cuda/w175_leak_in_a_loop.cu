// expect: bounds warning 9 leak
// Each step allocates a buffer, and only the last is freed.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void fill(float* x, float value) { x[threadIdx.x] = value; }
int main() {
    float *scratch = nullptr, last = 0;
    for (int step = 0; step < 3; ++step) {
        cudaMalloc(&scratch, 64 * sizeof(float));  // BUG: never freed but for the last
        fill<<<1, 64>>>(scratch, step);
        cudaMemcpy(&last, scratch, sizeof(float), cudaMemcpyDeviceToHost);
    }
    printf("%g\n", last);
    cudaFree(scratch);
}
