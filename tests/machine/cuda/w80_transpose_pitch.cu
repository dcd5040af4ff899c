// expect: bounds,watch error 9 out-of-bounds
// The transpose of a matrix that is not square, written with the pitch of the input.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void transpose(const float* in, float* out, int width, int height) {
    int x = blockIdx.x * 16 + threadIdx.x, y = blockIdx.y * 16 + threadIdx.y;
    if (x < width && y < height)
        out[x * width + y] = in[y * width + x];  // BUG: rows of out have height elements
}
int main() {
    const int width = 40, height = 24;
    std::vector<float> h(width * height, 1.f);
    float *in, *out;
    cudaMalloc(&in, h.size() * sizeof(float));
    cudaMalloc(&out, h.size() * sizeof(float));
    cudaMemcpy(in, h.data(), h.size() * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(out, 0, h.size() * sizeof(float));
    transpose<<<dim3((width + 15) / 16, (height + 15) / 16), dim3(16, 16)>>>(in, out, width, height);
    cudaMemcpy(h.data(), out, h.size() * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(in);
    cudaFree(out);
}
