// expect: bounds,watch error 8 out-of-bounds
// -1 marks the end of a list; pointer jumping looks it up without a test.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void jump(const int* next, int* next2, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) next2[i] = next[next[i]];  // BUG: next[i] may be -1
}
int main() {
    const int n = 64;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i + 1 < n ? i + 1 : -1;
    int *next, *next2;
    cudaMalloc(&next, n * sizeof(int));
    cudaMalloc(&next2, n * sizeof(int));
    cudaMemcpy(next, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    jump<<<1, n>>>(next, next2, n);
    cudaMemcpy(h.data(), next2, n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(next);
    cudaFree(next2);
}
