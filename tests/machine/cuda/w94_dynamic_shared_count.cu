// expect: plain,races,order,watch error 9 shared-overrun; bounds error 9 out-of-bounds
// The third argument of a launch counts bytes.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void reverse(float* x) {
    extern __shared__ float s[];
    int t = threadIdx.x, i = blockIdx.x * blockDim.x + t;
    s[t] = x[i];  // BUG: the launch gives blockDim.x bytes
    __syncthreads();
    x[i] = s[blockDim.x - 1 - t];
}
int main() {
    const int n = 1024, block = 256;
    std::vector<float> h(n, 1.f);
    float* x;
    cudaMalloc(&x, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    reverse<<<n / block, block, block>>>(x);
    cudaMemcpy(h.data(), x, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(x);
}
