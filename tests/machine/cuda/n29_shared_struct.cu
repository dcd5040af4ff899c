// expect: nothing
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
struct Box { float3 lo, hi; int n; };
__global__ void k(const float* a, float* b) {
    __shared__ Box box;
    __shared__ float3 p[4][8];
    int t = threadIdx.x;
    p[t / 8][t % 8] = make_float3(a[t], 1, 2);
    if (t == 0) { box.lo = make_float3(0, 0, 0); box.n = 3; }
    __syncthreads();
    b[t] = p[3 - t / 8][t % 8].x + box.n;
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
