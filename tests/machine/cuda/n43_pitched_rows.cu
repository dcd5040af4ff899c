// expect: nothing
// Rows of a pitched image, reached by bytes.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void flip(const float* in, float* out, size_t pitch, int w, int h) {
    int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y;
    if (x >= w || y >= h) return;
    const float* from = (const float*)((const char*)in + (h - 1 - y) * pitch);
    float* to = (float*)((char*)out + y * pitch);
    to[x] = from[x];
}
int main() {
    const int w = 37, h = 11;
    std::vector<float> image(w * h);
    for (int i = 0; i < w * h; ++i) image[i] = i;
    float *in, *out;
    size_t pitch;
    cudaMallocPitch((void**)&in, &pitch, w * sizeof(float), h);
    cudaMallocPitch((void**)&out, &pitch, w * sizeof(float), h);
    const size_t row = w * sizeof(float);
    cudaMemcpy2D(in, pitch, image.data(), row, row, h, cudaMemcpyHostToDevice);
    flip<<<dim3(5, 2), dim3(8, 8)>>>(in, out, pitch, w, h);
    cudaMemcpy2D(image.data(), row, out, pitch, row, h, cudaMemcpyDeviceToHost);
    printf("%g %g\n", image[0], image[w * h - 1]);
    cudaFree(in);
    cudaFree(out);
    return image[0] != w * (h - 1);
}
