// expect: plain,bounds,races,watch,order error 10|12 bad-mask
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__global__ void k(const float* a, float* b) {
    int t = threadIdx.x;
    unsigned m;
    if (a[t] > 3)
        m = __ballot_sync(0xffffffff, a[t] > 4);  // BUG
    else
        m = __ballot_sync(0xffffffff, a[t] > 1);  // BUG
    b[t] = m;
}
int main() {
    const int n = 256;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i % 7;
    float *a, *b;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&b, n * sizeof(float));
    cudaMemcpy(a, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(b, 0, n * sizeof(float));
    k<<<1, 32>>>(a, b);
    cudaMemcpy(h.data(), b, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g %g\n", h[0], h[n - 1]);
    cudaFree(a);
    cudaFree(b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
