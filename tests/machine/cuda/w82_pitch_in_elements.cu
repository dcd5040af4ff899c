// expect: bounds,watch error 8 out-of-bounds
// cudaMallocPitch() gives the pitch in bytes; here it counts floats.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void scale(float* image, size_t pitch, int width, int height, float by) {
    int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y;
    if (x < width && y < height) image[y * pitch + x] *= by;  // BUG: pitch is in bytes
}
int main() {
    const int width = 100, height = 20;
    std::vector<float> h(width * height, 3.f);
    float* image;
    size_t pitch;
    cudaMallocPitch((void**)&image, &pitch, width * sizeof(float), height);
    cudaMemcpy2D(image, pitch, h.data(), width * sizeof(float), width * sizeof(float), height,
                 cudaMemcpyHostToDevice);
    scale<<<dim3(1, height), 128>>>(image, pitch, width, height, 2.f);
    cudaMemcpy2D(h.data(), width * sizeof(float), image, pitch, width * sizeof(float), height,
                 cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(image);
}
