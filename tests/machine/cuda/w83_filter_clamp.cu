// expect: bounds,watch error 13 out-of-bounds
// A box filter that clamps to the width and height instead of to the last column and row.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void box(const float* in, float* out, int w, int h) {
    int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y;
    if (x >= w || y >= h) return;
    float sum = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            int u = min(max(x + dx, 0), w), v = min(max(y + dy, 0), h);
            sum += in[v * w + u];  // BUG: v == h is no row
        }
    out[y * w + x] = sum / 9;
}
int main() {
    const int w = 33, h = 21;
    std::vector<float> pixels(w * h, 1.f);
    float *in, *out;
    cudaMalloc(&in, w * h * sizeof(float));
    cudaMalloc(&out, w * h * sizeof(float));
    cudaMemcpy(in, pixels.data(), w * h * sizeof(float), cudaMemcpyHostToDevice);
    box<<<dim3(5, 3), dim3(8, 8)>>>(in, out, w, h);
    cudaMemcpy(pixels.data(), out, w * h * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", pixels[0]);
    cudaFree(in);
    cudaFree(out);
}
