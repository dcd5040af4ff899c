// expect: nothing
// The address of a __device__ function is taken on the device and copied from a symbol.
#include <cuda_runtime.h>
#include <cstdio>
typedef float (*Function)(float);
__device__ float square(float x) { return x * x; }
__device__ Function square_pointer = square;
__global__ void map(float* x, Function f) { x[threadIdx.x] = f(x[threadIdx.x] + 3); }
int main() {
    Function f;
    cudaMemcpyFromSymbol(&f, square_pointer, sizeof(f));
    float *x, first;
    cudaMalloc(&x, 32 * sizeof(float));
    cudaMemset(x, 0, 32 * sizeof(float));
    map<<<1, 32>>>(x, f);
    cudaMemcpy(&first, x, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaFree(x);
    return first != 9;
}
