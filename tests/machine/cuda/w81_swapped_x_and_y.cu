// expect: bounds,watch error 10 out-of-bounds
// An image whose guard compares x with the height and y with the width.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void invert(unsigned char* pixels, int width, int height) {
    int x = blockIdx.x * blockDim.x + threadIdx.x;
    int y = blockIdx.y * blockDim.y + threadIdx.y;
    if (x >= height || y >= width) return;
    pixels[y * width + x] = 255 - pixels[y * width + x];  // BUG: y goes up to width - 1
}
int main() {
    const int width = 96, height = 32;
    std::vector<unsigned char> h(width * height, 10);
    unsigned char* pixels;
    cudaMalloc(&pixels, h.size());
    cudaMemcpy(pixels, h.data(), h.size(), cudaMemcpyHostToDevice);
    dim3 block(16, 16), grid(height / 16, width / 16);
    invert<<<grid, block>>>(pixels, width, height);
    cudaMemcpy(h.data(), pixels, h.size(), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(pixels);
}
