// expect: bounds,watch error 12 out-of-bounds
// A lower bound whose upper end is n instead of n - 1 in a loop with <=.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void lower_bound(const int* sorted, int n, const int* keys, int* found, int count) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= count) return;
    int low = 0, high = n;
    while (low <= high) {
        int middle = (low + high) / 2;
        if (sorted[middle] < keys[i])  // BUG: middle may be n
            low = middle + 1;
        else
            high = middle - 1;
    }
    found[i] = low;
}
int main() {
    const int n = 50, count = 64;
    std::vector<int> h(n), k(count);
    for (int i = 0; i < n; ++i) h[i] = 2 * i;
    for (int i = 0; i < count; ++i) k[i] = 3 * i;
    int *sorted, *keys, *found;
    cudaMalloc(&sorted, n * sizeof(int));
    cudaMalloc(&keys, count * sizeof(int));
    cudaMalloc(&found, count * sizeof(int));
    cudaMemcpy(sorted, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemcpy(keys, k.data(), count * sizeof(int), cudaMemcpyHostToDevice);
    lower_bound<<<1, count>>>(sorted, n, keys, found, count);
    cudaMemcpy(k.data(), found, count * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", k[1]);
    cudaFree(sorted);
    cudaFree(keys);
    cudaFree(found);
}
