// expect: plain,bounds,races,watch,order error 15 bad-source
// The last lane's sum is sent to all, but in the tail the last lane takes no part.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void normalise(float* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x, lane = threadIdx.x % 32;
    unsigned mask = __ballot_sync(0xffffffff, i < n);
    if (i >= n) return;
    float sum = x[i];
    for (int d = 1; d < 32; d *= 2) {
        float left = __shfl_up_sync(mask, sum, d);
        if (lane >= d) sum += left;
    }
    float total = __shfl_sync(mask, sum, 31);  // BUG: lane 31 has returned
    x[i] /= total;
}
int main() {
    const int n = 52;
    std::vector<float> h(n, 1.f);
    float* x;
    cudaMalloc(&x, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    normalise<<<1, 64>>>(x, n);
    cudaMemcpy(h.data(), x, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(x);
}
