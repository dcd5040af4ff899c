// expect: watch error 16 race|unsynchronised
// The host fills its buffer for the next piece while the last piece may still be copied.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void add(const int* piece, int* sums) { sums[threadIdx.x] += piece[threadIdx.x]; }
int main() {
    const int n = 64;
    int *h, *piece, *sums;
    cudaMallocHost((void**)&h, n * sizeof(int));
    cudaMalloc(&piece, n * sizeof(int));
    cudaMalloc(&sums, n * sizeof(int));
    cudaMemset(sums, 0, n * sizeof(int));
    cudaStream_t stream;
    cudaStreamCreate(&stream);
    for (int p = 0; p < 3; ++p) {
        for (int i = 0; i < n; ++i) h[i] = p * i;  // BUG: the last copy may still read h
        cudaMemcpyAsync(piece, h, n * sizeof(int), cudaMemcpyHostToDevice, stream);
        add<<<1, n, 0, stream>>>(piece, sums);
    }
    cudaStreamSynchronize(stream);
    int last;
    cudaMemcpy(&last, sums + n - 1, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", last);
    cudaStreamDestroy(stream);
    cudaFreeHost(h);
    cudaFree(piece);
    cudaFree(sums);
}
