// expect: plain,bounds,races,watch,order error 18 bad-copy
// The pitch of the host's rows is given in elements: less than the width of a row in bytes.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void negate(float* image, size_t pitch, int w, int h) {
    int x = threadIdx.x, y = blockIdx.x;
    float* row = (float*)((char*)image + y * pitch);
    if (x < w && y < h) row[x] = -row[x];
}
int main() {
    const int w = 50, h = 10;
    std::vector<float> host(w * h, 1.f);
    float* image;
    size_t pitch;
    cudaMallocPitch((void**)&image, &pitch, w * sizeof(float), h);
    cudaMemset2D(image, pitch, 0, w * sizeof(float), h);
    cudaMemcpy2D(image, pitch, host.data(), w, w * sizeof(float), h, cudaMemcpyHostToDevice);  // BUG
    negate<<<h, 64>>>(image, pitch, w, h);
    cudaMemcpy2D(host.data(), w * sizeof(float), image, pitch, w * sizeof(float), h,
                 cudaMemcpyDeviceToHost);
    printf("%g\n", host[0]);
    cudaFree(image);
}
