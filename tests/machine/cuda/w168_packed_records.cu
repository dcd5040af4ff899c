// expect: bounds,watch error 8 misaligned
// Records of 12 bytes are read as a number of 8 bytes at offset 4.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void read_ids(const unsigned char* records, unsigned long long* ids, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) ids[i] = *(const unsigned long long*)(records + 12 * i + 4);  // BUG: 4 is no multiple of 8
}
int main() {
    const int n = 32;
    std::vector<unsigned char> h(12 * n, 1);
    unsigned char* records;
    unsigned long long *ids, first;
    cudaMalloc(&records, h.size());
    cudaMalloc(&ids, n * sizeof(unsigned long long));
    cudaMemcpy(records, h.data(), h.size(), cudaMemcpyHostToDevice);
    read_ids<<<1, n>>>(records, ids, n);
    cudaMemcpy(&first, ids, sizeof(first), cudaMemcpyDeviceToHost);
    printf("%llu\n", first);
    cudaFree(records);
    cudaFree(ids);
}
