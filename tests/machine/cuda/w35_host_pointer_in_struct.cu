// expect: watch error 7 host-memory
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
struct Args { const float* a; float* b; };
__global__ void k(Args s) { s.b[threadIdx.x] = s.a[threadIdx.x]; }
int main() {
    std::vector<float> h(64, 1.f);
    Args s; s.a = h.data();
    cudaMalloc(&s.b, 64 * sizeof(float));
    k<<<1, 64>>>(s);  // BUG
    cudaMemcpy(h.data(), s.b, 64 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[5]);
    cudaFree(s.b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
