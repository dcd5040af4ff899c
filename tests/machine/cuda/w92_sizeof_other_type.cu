// expect: bounds,watch error 9 out-of-bounds
// Memory for doubles is allocated with the size of a float.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void integrate(double* area, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    double x = (i + 0.5) / n;
    area[i] = 4 / (1 + x * x) / n;  // BUG: area has room for n / 2 doubles
}
int main() {
    const int n = 512;
    double* area;
    cudaMalloc((void**)&area, n * sizeof(float));
    integrate<<<n / 64, 64>>>(area, n);
    double first;
    cudaMemcpy(&first, area, sizeof(double), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaFree(area);
}
