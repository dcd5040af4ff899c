// expect: watch error 17 race|unsynchronised
// The result of an asynchronous copy is read at once.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void twice(float* x) { x[threadIdx.x] *= 2; }
int main() {
    const int n = 64;
    float *h, *d;
    cudaMallocHost((void**)&h, n * sizeof(float));
    cudaMalloc(&d, n * sizeof(float));
    for (int i = 0; i < n; ++i) h[i] = i;
    cudaStream_t stream;
    cudaStreamCreate(&stream);
    cudaMemcpyAsync(d, h, n * sizeof(float), cudaMemcpyHostToDevice, stream);
    twice<<<1, n, 0, stream>>>(d);
    cudaMemcpyAsync(h, d, n * sizeof(float), cudaMemcpyDeviceToHost, stream);
    printf("%g\n", h[1]);  // BUG: no cudaStreamSynchronize()
    cudaStreamSynchronize(stream);
    cudaStreamDestroy(stream);
    cudaFreeHost(h);
    cudaFree(d);
}
