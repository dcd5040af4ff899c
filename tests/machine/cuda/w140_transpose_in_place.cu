// expect: races,watch error 8 race
// A transpose that needs two matrices is called with one.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void transpose(const int* in, int* out, int n) {
    int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y;
    if (x < n && y < n) out[x * n + y] = in[y * n + x];  // BUG: in == out
}
int main() {
    const int n = 16;
    std::vector<int> h(n * n);
    for (int i = 0; i < n * n; ++i) h[i] = i;
    int* m;
    cudaMalloc(&m, n * n * sizeof(int));
    cudaMemcpy(m, h.data(), n * n * sizeof(int), cudaMemcpyHostToDevice);
    transpose<<<dim3(2, 2), dim3(8, 8)>>>(m, m, n);
    cudaMemcpy(h.data(), m, n * n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(m);
}
