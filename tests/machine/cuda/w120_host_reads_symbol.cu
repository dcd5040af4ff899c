// expect: watch error 20 host-reads-device|host-dereference
// A __device__ variable is read by name in host code, which sees a copy that is never written.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__device__ int hits;
__global__ void count(const float* x, int n, float limit) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n && x[i] > limit) atomicAdd(&hits, 1);
}
int main() {
    const int n = 200;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    float* x;
    cudaMalloc(&x, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    count<<<2, 128>>>(x, n, 99.5f);
    cudaDeviceSynchronize();
    printf("%d\n", hits);  // BUG: cudaMemcpyFromSymbol()
    cudaFree(x);
}
