// expect: plain,bounds,races,watch,order error 18 bad-launch
// More than 48 KiB of dynamic shared memory without cudaFuncSetAttribute().
#include <cuda_runtime.h>
#include <cstdio>
__global__ void cache(float* x, int n) {
    extern __shared__ float s[];
    for (int i = threadIdx.x; i < n; i += blockDim.x) s[i] = i;
    __syncthreads();
    float sum = 0;
    for (int i = threadIdx.x; i < n; i += blockDim.x) sum += s[n - 1 - i];
    x[threadIdx.x] = sum;
}
int main() {
    const int n = 16384;
    float* x;
    cudaMalloc(&x, 128 * sizeof(float));
    cudaMemset(x, 0, 128 * sizeof(float));
    cache<<<1, 128, n * sizeof(float)>>>(x, n);  // BUG: 64 KiB
    float first;
    cudaMemcpy(&first, x, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaFree(x);
}
