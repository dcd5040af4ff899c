// expect: plain,bounds,races,watch,order error 23 bad-launch
// 64 x 32 threads are more than the 1024 of a block.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void gray(const uchar3* in, unsigned char* out, int w, int h) {
    int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y;
    if (x >= w || y >= h) return;
    uchar3 p = in[y * w + x];
    out[y * w + x] = (p.x * 77 + p.y * 150 + p.z * 29) / 256;
}
int main() {
    const int w = 128, h = 64;
    std::vector<uchar3> pixels(w * h, make_uchar3(10, 20, 30));
    std::vector<unsigned char> result(w * h);
    uchar3* in;
    unsigned char* out;
    cudaMalloc(&in, w * h * sizeof(uchar3));
    cudaMalloc(&out, w * h);
    cudaMemset(out, 0, w * h);
    cudaMemcpy(in, pixels.data(), w * h * sizeof(uchar3), cudaMemcpyHostToDevice);
    dim3 block(64, 32), grid((w + 63) / 64, (h + 31) / 32);
    gray<<<grid, block>>>(in, out, w, h);  // BUG: 2048 threads a block
    cudaMemcpy(result.data(), out, w * h, cudaMemcpyDeviceToHost);
    printf("%d\n", result[0]);
    cudaFree(in);
    cudaFree(out);
}
