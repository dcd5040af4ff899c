// expect: plain,bounds,races,watch,order error 16 bad-free; maybe warning 9 leak
// The pointer that is freed has been moved along the array.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void fill(float* x, float value) { x[threadIdx.x] = value; }
int main() {
    const int chunk = 64, chunks = 4;
    float *x, last;
    cudaMalloc(&x, chunks * chunk * sizeof(float));
    for (int c = 0; c < chunks; ++c) {
        fill<<<1, chunk>>>(x, c);
        cudaMemcpy(&last, x, sizeof(float), cudaMemcpyDeviceToHost);
        if (c + 1 < chunks) x += chunk;
    }
    printf("%g\n", last);
    cudaFree(x);  // BUG: not the start
}
