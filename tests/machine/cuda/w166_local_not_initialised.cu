// expect: host warning 7|8 uninitialised-local
// A sum in a local variable that does not start at 0.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void dot(const float* a, const float* b, float* out, int n) {
    float sum;  // BUG
    for (int i = threadIdx.x; i < n; i += blockDim.x) sum += a[i] * b[i];  // BUG
    out[threadIdx.x] = sum;
}
int main() {
    const int n = 128;
    std::vector<float> h(n, 1.f);
    float *a, *out, first;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&out, 32 * sizeof(float));
    cudaMemcpy(a, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    dot<<<1, 32>>>(a, a, out, n);
    cudaMemcpy(&first, out, sizeof(float), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(a);
    cudaFree(out);
}
