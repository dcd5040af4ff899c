// expect: watch error 5|6 race|unsynchronised
// The event stands before the kernel that the other stream should wait for.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void produce(float* x) { x[threadIdx.x] = threadIdx.x; }  // BUG
__global__ void consume(const float* x, float* y) { y[threadIdx.x] = 3 * x[threadIdx.x]; }  // BUG
int main() {
    const int n = 64;
    float *x, *y, last;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&y, n * sizeof(float));
    cudaStream_t one, two;
    cudaStreamCreate(&one);
    cudaStreamCreate(&two);
    cudaEvent_t ready;
    cudaEventCreate(&ready);
    cudaEventRecord(ready, one);
    produce<<<1, n, 0, one>>>(x);
    cudaStreamWaitEvent(two, ready, 0);
    consume<<<1, n, 0, two>>>(x, y);
    cudaDeviceSynchronize();
    cudaMemcpy(&last, y + n - 1, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", last);
    cudaEventDestroy(ready);
    cudaStreamDestroy(one);
    cudaStreamDestroy(two);
    cudaFree(x);
    cudaFree(y);
}
