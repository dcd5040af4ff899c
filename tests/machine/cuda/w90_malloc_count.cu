// expect: plain,bounds,races,watch,order error 15 bad-copy; maybe error 8 uninitialised-global
// cudaMalloc() is given the number of elements, not of bytes.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void twice(float* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) x[i] *= 2;
}
int main() {
    const int n = 256;
    std::vector<float> h(n, 1.f);
    float* x;
    cudaMalloc(&x, n);
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);  // BUG: x has n bytes
    twice<<<1, n / 4>>>(x, n / 4);
    cudaMemcpy(h.data(), x, n / 4 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(x);
}
