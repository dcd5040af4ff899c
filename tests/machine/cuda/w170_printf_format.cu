// expect: host warning 6 printf-format
// A double is printed as an integer.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void show(const float* x) {
    if (threadIdx.x == 0) printf("x[0] = %d of thread %d\n", x[0], threadIdx.x);  // BUG: %f
}
int main() {
    float* x;
    cudaMalloc(&x, 32 * sizeof(float));
    cudaMemset(x, 0, 32 * sizeof(float));
    show<<<1, 32>>>(x);
    cudaDeviceSynchronize();
    cudaFree(x);
}
