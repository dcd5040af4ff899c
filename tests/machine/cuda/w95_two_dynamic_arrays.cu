// expect: plain,races,order,watch error 12 shared-overrun; bounds error 12 out-of-bounds
// Keys and values lie in one dynamic array, but the launch asks for the keys only.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void odd_even_sort(int* keys, float* values, int n) {
    extern __shared__ unsigned char memory[];
    int* k = (int*)memory;
    float* v = (float*)(k + n);
    int t = threadIdx.x;
    k[t] = keys[t];
    v[t] = values[t];  // BUG: v lies behind the end
    __syncthreads();
    for (int step = 0; step < n; ++step) {
        if (t % 2 == step % 2 && t + 1 < n && k[t] > k[t + 1]) {
            int a = k[t]; k[t] = k[t + 1]; k[t + 1] = a;
            float b = v[t]; v[t] = v[t + 1]; v[t + 1] = b;
        }
        __syncthreads();
    }
    keys[t] = k[t];
    values[t] = v[t];
}
int main() {
    const int n = 64;
    std::vector<int> hk(n);
    std::vector<float> hv(n);
    for (int i = 0; i < n; ++i) hk[i] = hv[i] = n - i;
    int* keys;
    float* values;
    cudaMalloc(&keys, n * sizeof(int));
    cudaMalloc(&values, n * sizeof(float));
    cudaMemcpy(keys, hk.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemcpy(values, hv.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    odd_even_sort<<<1, n, n * sizeof(int)>>>(keys, values, n);
    cudaMemcpy(hv.data(), values, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", hv[0]);
    cudaFree(keys);
    cudaFree(values);
}
