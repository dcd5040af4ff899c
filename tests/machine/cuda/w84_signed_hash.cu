// expect: bounds,watch error 12 out-of-bounds; bounds warning 7 integer-overflow
// A hash table whose hash overflows int, so that the remainder is negative.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__device__ int slot_of(int key, int slots) {
    int hash = key * 1103515245 + 12345;  // BUG: overflows int
    return hash % slots;
}
__global__ void count(const int* keys, int* table, int n, int slots) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) atomicAdd(&table[slot_of(keys[i], slots)], 1);  // BUG: a negative index
}
int main() {
    const int n = 500, slots = 64;
    std::vector<int> keys(n), counts(slots);
    for (int i = 0; i < n; ++i) keys[i] = 17 * i + 3;
    int *d_keys, *d_table;
    cudaMalloc(&d_keys, n * sizeof(int));
    cudaMalloc(&d_table, slots * sizeof(int));
    cudaMemcpy(d_keys, keys.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(d_table, 0, slots * sizeof(int));
    count<<<(n + 127) / 128, 128>>>(d_keys, d_table, n, slots);
    cudaMemcpy(counts.data(), d_table, slots * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", counts[0]);
    cudaFree(d_keys);
    cudaFree(d_table);
}
