// expect: bounds warning 8 float-cast-overflow
// A float that is greater than 255 is made a byte.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void brighten(unsigned char* pixels, int n, float by) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) pixels[i] = (unsigned char)(pixels[i] * by);  // BUG: fminf(255, ...)
}
int main() {
    const int n = 256;
    std::vector<unsigned char> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    unsigned char* pixels;
    cudaMalloc(&pixels, n);
    cudaMemcpy(pixels, h.data(), n, cudaMemcpyHostToDevice);
    brighten<<<2, 128>>>(pixels, n, 1.5f);
    cudaMemcpy(h.data(), pixels, n, cudaMemcpyDeviceToHost);
    printf("%d\n", h[100]);
    cudaFree(pixels);
}
