// expect: none error 14 host-function|host-pointer
// The address of a __device__ function, taken by host code, is no address of the device.
#include <cuda_runtime.h>
#include <cstdio>
typedef float (*Function)(float);
__device__ float square(float x) { return x * x; }
__device__ float halve(float x) { return x / 2; }
__global__ void map(float* x, Function f) { x[threadIdx.x] = f(x[threadIdx.x]); }
int main() {
    float* x;
    cudaMalloc(&x, 32 * sizeof(float));
    cudaMemset(x, 0, 32 * sizeof(float));
    bool use_square = true;
    map<<<1, 32>>>(x, use_square ? square : halve);  // BUG: taken by the host
    float first;
    cudaMemcpy(&first, x, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaFree(x);
}
