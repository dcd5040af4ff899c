// expect: nothing
#include <cuda_runtime.h>
#include <cstdio>
#include <thread>
#include <vector>
// Launches by a thread of the host other than the first one: shared memory works there too, and what the host's
// threads do meanwhile is none of the kernel's business.
__global__ void reverse(int* values) {
    __shared__ int copy[64];
    copy[threadIdx.x] = values[threadIdx.x];
    __syncthreads();
    values[threadIdx.x] = copy[63 - threadIdx.x];
}
void launch(int first, int* last) {
    std::vector<int> host(64);
    for (int i = 0; i < 64; ++i) host[i] = first + i;
    int* values;
    cudaMalloc(&values, 64 * sizeof(int));
    for (int round = 0; round < 21; ++round) {
        cudaMemcpy(values, host.data(), 64 * sizeof(int), cudaMemcpyHostToDevice);
        reverse<<<1, 64>>>(values);
        cudaMemcpy(host.data(), values, 64 * sizeof(int), cudaMemcpyDeviceToHost);
    }
    cudaFree(values);
    *last = host[63];
}
int main() {
    int a = 0, b = 0;
    std::thread other(launch, 100, &a);
    launch(200, &b);
    other.join();
    printf("%d %d\n", a, b);
    return a != 100 || b != 200;
}
