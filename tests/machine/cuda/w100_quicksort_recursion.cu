// expect: watch error 6|16 stack-overflow
// Quicksort of sorted numbers goes as deep as there are numbers; the stack of a thread has 1 kB.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__device__ void quicksort(int* x, int low, int high) {  // BUG
    if (low >= high) return;
    int pivot = x[high], at = low;
    for (int i = low; i < high; ++i)
        if (x[i] < pivot) {
            int y = x[i]; x[i] = x[at]; x[at] = y;
            ++at;
        }
    x[high] = x[at];
    x[at] = pivot;
    quicksort(x, low, at - 1);  // BUG: 300 calls deep
    quicksort(x, at + 1, high);
}
__global__ void sort(int* x, int n) { quicksort(x + threadIdx.x * n, 0, n - 1); }
int main() {
    const int n = 300, lists = 4;
    std::vector<int> h(n * lists);
    for (int i = 0; i < n * lists; ++i) h[i] = i;
    int* x;
    cudaMalloc(&x, h.size() * sizeof(int));
    cudaMemcpy(x, h.data(), h.size() * sizeof(int), cudaMemcpyHostToDevice);
    sort<<<1, lists>>>(x, n);
    cudaMemcpy(h.data(), x, h.size() * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[5]);
    cudaFree(x);
}
