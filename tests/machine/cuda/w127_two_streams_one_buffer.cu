// expect: watch error 5|6 race|unsynchronised
// One stream writes what the other reads, and nothing orders the two.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void produce(float* x) { x[threadIdx.x] = 2 * threadIdx.x; }  // BUG
__global__ void consume(const float* x, float* y) { y[threadIdx.x] = x[threadIdx.x] + 1; }  // BUG
int main() {
    const int n = 128;
    float *x, *y, first;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&y, n * sizeof(float));
    cudaMemset(x, 0, n * sizeof(float));
    cudaDeviceSynchronize();
    cudaStream_t one, two;
    cudaStreamCreateWithFlags(&one, cudaStreamNonBlocking);
    cudaStreamCreateWithFlags(&two, cudaStreamNonBlocking);
    produce<<<1, n, 0, one>>>(x);
    consume<<<1, n, 0, two>>>(x, y);
    cudaStreamSynchronize(one);
    cudaStreamSynchronize(two);
    cudaMemcpy(&first, y, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaStreamDestroy(one);
    cudaStreamDestroy(two);
    cudaFree(x);
    cudaFree(y);
}
