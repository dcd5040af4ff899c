// expect: plain,bounds,races,watch,order error 9 bad-mask
// The mask names lanes that have returned.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void count_above(const float* x, int n, float limit, int* count) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    unsigned votes = __ballot_sync(0xffffffff, x[i] > limit);  // BUG: some have returned
    if (threadIdx.x % 32 == 0) atomicAdd(count, __popc(votes));
}
int main() {
    const int n = 75;
    std::vector<float> h(n, 1.f);
    float* x;
    int *count, result = 0;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&count, sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(count, 0, sizeof(int));
    count_above<<<2, 64>>>(x, n, 0.5f, count);
    cudaMemcpy(&result, count, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(x);
    cudaFree(count);
}
