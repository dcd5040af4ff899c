// expect: nothing
// Two streams, each with its own buffers, and a wait before a host buffer is filled again.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void square(int* x) { x[threadIdx.x] *= x[threadIdx.x]; }
int main() {
    const int n = 64, pieces = 4;
    int *h[2], *d[2], sum = 0;
    cudaStream_t stream[2];
    for (int s = 0; s < 2; ++s) {
        cudaMallocHost((void**)&h[s], n * sizeof(int));
        cudaMalloc(&d[s], n * sizeof(int));
        cudaStreamCreate(&stream[s]);
    }
    for (int p = 0; p < pieces; ++p) {
        const int s = p % 2;
        if (p >= 2) {
            cudaStreamSynchronize(stream[s]);
            sum += h[s][1];
        }
        for (int i = 0; i < n; ++i) h[s][i] = p + i;
        cudaMemcpyAsync(d[s], h[s], n * sizeof(int), cudaMemcpyHostToDevice, stream[s]);
        square<<<1, n, 0, stream[s]>>>(d[s]);
        cudaMemcpyAsync(h[s], d[s], n * sizeof(int), cudaMemcpyDeviceToHost, stream[s]);
    }
    cudaDeviceSynchronize();
    sum += h[0][1] + h[1][1];
    printf("%d\n", sum);
    for (int s = 0; s < 2; ++s) {
        cudaFreeHost(h[s]);
        cudaFree(d[s]);
        cudaStreamDestroy(stream[s]);
    }
    return sum != 1 + 4 + 9 + 16;
}
