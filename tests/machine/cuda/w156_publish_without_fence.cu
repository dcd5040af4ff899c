// expect: watch error 9|14 race
// The flag is atomic, but the data may arrive behind it.
#include <cuda_runtime.h>
#include <cstdio>
__device__ unsigned turn;
__global__ void hand_over(float* data, int* ready, float* out) {
    if (threadIdx.x != 0) return;
    if (atomicAdd(&turn, 1) == 0) {
        data[0] = 3.5f;  // BUG: __threadfence() is missing behind it
        atomicExch(ready, 1);
    } else {
        while (atomicAdd(ready, 0) == 0) {
        }
        out[0] = data[0];  // BUG
    }
}
int main() {
    float *data, *out, result = 0;
    int* ready;
    cudaMalloc(&data, sizeof(float));
    cudaMalloc(&out, sizeof(float));
    cudaMalloc(&ready, sizeof(int));
    cudaMemset(ready, 0, sizeof(int));
    hand_over<<<2, 32>>>(data, ready, out);
    cudaMemcpy(&result, out, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", result);
    cudaFree(data);
    cudaFree(out);
    cudaFree(ready);
}
