// expect: bounds,watch error 9 out-of-bounds
// A blur of three points whose guard stands only at the right end.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void blur(const float* in, float* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i + 1 < n)
        out[i] = (in[i - 1] + in[i] + in[i + 1]) / 3;  // BUG: in[-1]
}
int main() {
    const int n = 512;
    std::vector<float> h(n, 2.f);
    float *in, *out;
    cudaMalloc(&in, n * sizeof(float));
    cudaMalloc(&out, n * sizeof(float));
    cudaMemcpy(in, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(out, 0, n * sizeof(float));
    blur<<<n / 128, 128>>>(in, out, n);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g %g\n", h[1], h[n - 2]);
    cudaFree(in);
    cudaFree(out);
}
