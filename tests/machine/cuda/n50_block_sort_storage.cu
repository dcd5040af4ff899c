// expect: nothing
// A block primitive with storage in a union, as CUB's; a barrier stands before it is used again.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
struct BlockScan {
    union Storage {
        int sums[64];
        int total;
    };
    Storage& storage;
    __device__ int exclusive(int value, int& total) {
        int t = threadIdx.x;
        storage.sums[t] = value;
        __syncthreads();
        int sum = 0;
        for (int i = 0; i < t; ++i) sum += storage.sums[i];
        __syncthreads();
        if (t == 63) storage.total = sum + value;
        __syncthreads();
        total = storage.total;
        return sum;
    }
};
__global__ void radix_sort(unsigned* keys) {
    __shared__ union {
        BlockScan::Storage scan;
        unsigned keys[64];
    } s;
    unsigned key = keys[threadIdx.x];
    for (int bit = 0; bit < 8; ++bit) {
        int one = key >> bit & 1, zeros;
        int place = BlockScan{s.scan}.exclusive(1 - one, zeros);
        if (one) place = zeros + threadIdx.x - place;
        __syncthreads();
        s.keys[place] = key;
        __syncthreads();
        key = s.keys[threadIdx.x];
        __syncthreads();
    }
    keys[threadIdx.x] = key;
}
int main() {
    std::vector<unsigned> h(64);
    for (int i = 0; i < 64; ++i) h[i] = (i * 149 + 31) % 251;
    unsigned* keys;
    cudaMalloc(&keys, 64 * sizeof(unsigned));
    cudaMemcpy(keys, h.data(), 64 * sizeof(unsigned), cudaMemcpyHostToDevice);
    radix_sort<<<1, 64>>>(keys);
    cudaMemcpy(h.data(), keys, 64 * sizeof(unsigned), cudaMemcpyDeviceToHost);
    bool sorted = true;
    for (int i = 1; i < 64; ++i) sorted &= h[i - 1] <= h[i];
    printf("%s\n", sorted ? "sorted" : "not sorted");
    cudaFree(keys);
    return !sorted;
}
