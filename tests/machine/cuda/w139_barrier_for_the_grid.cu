// expect: races,watch error 8|10 race
// __syncthreads() is taken for a barrier of all blocks between the two halves of a smoothing.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void smooth(const float* in, float* tmp, float* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) tmp[i] = 0.5f * (in[i] + in[min(i + 1, n - 1)]);  // BUG
    __syncthreads();
    if (i < n) out[i] = 0.5f * (tmp[i] + tmp[max(i - 1, 0)]);  // BUG: of the block before
}
int main() {
    const int n = 256;
    std::vector<float> h(n, 1.f);
    float *in, *tmp, *out;
    cudaMalloc(&in, n * sizeof(float));
    cudaMalloc(&tmp, n * sizeof(float));
    cudaMalloc(&out, n * sizeof(float));
    cudaMemcpy(in, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(tmp, 0, n * sizeof(float));
    smooth<<<4, 64>>>(in, tmp, out, n);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%d\n", h[5] > 0);
    cudaFree(in);
    cudaFree(tmp);
    cudaFree(out);
}
