// expect: bounds,watch error 12 out-of-bounds
// A volume whose index multiplies by the wrong extents.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
struct Extent { int nx, ny, nz; };
__global__ void fill(float* volume, Extent e) {
    int x = blockIdx.x * blockDim.x + threadIdx.x;
    int y = blockIdx.y * blockDim.y + threadIdx.y;
    int z = blockIdx.z * blockDim.z + threadIdx.z;
    if (x >= e.nx || y >= e.ny || z >= e.nz) return;
    volume[(z * e.nx + y) * e.nx + x] = x + y + z;  // BUG: z * e.ny
}
int main() {
    const Extent e{20, 10, 6};
    const size_t size = e.nx * e.ny * e.nz;
    float* volume;
    cudaMalloc(&volume, size * sizeof(float));
    cudaMemset(volume, 0, size * sizeof(float));
    dim3 block(8, 4, 2);
    dim3 grid((e.nx + 7) / 8, (e.ny + 3) / 4, (e.nz + 1) / 2);
    fill<<<grid, block>>>(volume, e);
    std::vector<float> h(size);
    cudaMemcpy(h.data(), volume, size * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[1]);
    cudaFree(volume);
}
