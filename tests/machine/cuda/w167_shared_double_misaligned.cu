// expect: bounds,watch error 12|17 misaligned
// Doubles begin behind an odd number of floats of dynamic shared memory.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void moments(double* out, int n) {
    extern __shared__ float memory[];
    float* x = memory;
    double* squares = (double*)(x + n);
    int t = threadIdx.x;
    if (t < n) {
        x[t] = t;
        squares[t] = double(x[t]) * x[t];  // BUG: the address is no multiple of 8 if n is odd
    }
    __syncthreads();
    if (t == 0) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += squares[i];  // BUG
        *out = sum;
    }
}
int main() {
    const int n = 33;
    double *out, result = 0;
    cudaMalloc(&out, sizeof(double));
    moments<<<1, 64, n * (sizeof(float) + sizeof(double))>>>(out, n);
    cudaMemcpy(&result, out, sizeof(double), cudaMemcpyDeviceToHost);
    printf("%g\n", result);
    cudaFree(out);
}
