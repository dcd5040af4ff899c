// expect: nothing
// The second stream waits for an event behind the first one's kernel.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void produce(float* x) { x[threadIdx.x] = threadIdx.x; }
__global__ void consume(const float* x, float* y) { y[threadIdx.x] = 2 * x[63 - threadIdx.x]; }
int main() {
    float *x, *y, *h;
    cudaMalloc(&x, 64 * sizeof(float));
    cudaMalloc(&y, 64 * sizeof(float));
    cudaMallocHost((void**)&h, 64 * sizeof(float));
    cudaStream_t one, two;
    cudaStreamCreateWithFlags(&one, cudaStreamNonBlocking);
    cudaStreamCreateWithFlags(&two, cudaStreamNonBlocking);
    cudaEvent_t ready;
    cudaEventCreateWithFlags(&ready, cudaEventDisableTiming);
    for (int round = 0; round < 2; ++round) {
        produce<<<1, 64, 0, one>>>(x);
        cudaEventRecord(ready, one);
        cudaStreamWaitEvent(two, ready, 0);
        consume<<<1, 64, 0, two>>>(x, y);
        cudaMemcpyAsync(h, y, 64 * sizeof(float), cudaMemcpyDeviceToHost, two);
        cudaEventRecord(ready, two);
        cudaStreamWaitEvent(one, ready, 0);
    }
    cudaStreamSynchronize(two);
    printf("%g\n", h[0]);
    const bool right = h[0] == 126;
    cudaEventDestroy(ready);
    cudaStreamDestroy(one);
    cudaStreamDestroy(two);
    cudaFree(x);
    cudaFree(y);
    cudaFreeHost(h);
    return !right;
}
