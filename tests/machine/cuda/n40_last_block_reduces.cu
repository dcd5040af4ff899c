// expect: nothing
// threadFenceReduction of NVIDIA's samples: all threads of the last block read all partial sums.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__device__ unsigned retired = 0;
__device__ float block_sum(float value, float* s) {
    int t = threadIdx.x;
    s[t] = value;
    __syncthreads();
    for (int d = 32; d > 0; d /= 2) {
        if (t < d) s[t] += s[t + d];
        __syncthreads();
    }
    float sum = s[0];
    __syncthreads();
    return sum;
}
__global__ void sum(const float* in, int n, float* partial, float* out) {
    __shared__ float s[64];
    __shared__ bool is_last;
    float mine = 0;
    for (int i = blockIdx.x * 64 + threadIdx.x; i < n; i += gridDim.x * 64) mine += in[i];
    float total = block_sum(mine, s);
    if (threadIdx.x == 0) {
        partial[blockIdx.x] = total;
        __threadfence();
        is_last = atomicInc(&retired, gridDim.x) == gridDim.x - 1;
    }
    __syncthreads();
    if (is_last) {
        __threadfence();
        float part = threadIdx.x < gridDim.x ? partial[threadIdx.x] : 0;
        total = block_sum(part, s);
        if (threadIdx.x == 0) {
            *out = total;
            retired = 0;
        }
    }
}
int main() {
    const int n = 1000;
    std::vector<float> h(n, 1.f);
    float *in, *partial, *out, result;
    cudaMalloc(&in, n * sizeof(float));
    cudaMalloc(&partial, 5 * sizeof(float));
    cudaMalloc(&out, sizeof(float));
    cudaMemcpy(in, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    for (int run = 0; run < 2; ++run) sum<<<5, 64>>>(in, n, partial, out);
    cudaMemcpy(&result, out, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", result);
    cudaFree(in);
    cudaFree(partial);
    cudaFree(out);
    return result != n;
}
