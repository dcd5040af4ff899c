// expect: bounds error 5 missing-return
// A device function that returns nothing on one way.
#include <cuda_runtime.h>
#include <cstdio>
__device__ float activation(float x, int kind) {  // BUG: nothing for kind 2
    if (kind == 0) return fmaxf(x, 0.f);
    if (kind == 1) return 1 / (1 + expf(-x));
}
__global__ void layer(float* x, int kind) { x[threadIdx.x] = activation(x[threadIdx.x], kind); }
int main(int count, char**) {
    float *x, first = 0;
    cudaMalloc(&x, 32 * sizeof(float));
    cudaMemset(x, 0, 32 * sizeof(float));
    layer<<<1, 32>>>(x, 1 + count);
    cudaMemcpy(&first, x, sizeof(float), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(x);
}
