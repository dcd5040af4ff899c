// expect: plain,bounds,races,watch,order error 9 bad-mask
// Lanes leave the grid-stride loop after different numbers of rounds, and the shuffle names all.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void runs(const int* x, int n, int* starts) {
    int count = 0;
    for (int i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += gridDim.x * blockDim.x) {
        int left = __shfl_up_sync(0xffffffff, x[i], 1);  // BUG: not all lanes come to the last round
        if (threadIdx.x % 32 == 0) left = i > 0 ? x[i - 1] : -1;
        count += left != x[i];
    }
    atomicAdd(starts, count);
}
int main() {
    const int n = 150;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i / 10;
    int *x, *starts, result = 0;
    cudaMalloc(&x, n * sizeof(int));
    cudaMalloc(&starts, sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(starts, 0, sizeof(int));
    runs<<<1, 64>>>(x, n, starts);
    cudaMemcpy(&result, starts, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(x);
    cudaFree(starts);
}
