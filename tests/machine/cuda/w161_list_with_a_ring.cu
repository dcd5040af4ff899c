// expect: plain,bounds,races,watch,order error 8 endless-loop
// The last node of a list points back to the first.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void length(const int* next, int head, int* out) {
    int count = 0;
    for (int node = head; node >= 0; node = next[node]) ++count;  // BUG: never negative
    *out = count;
}
int main() {
    const int n = 10;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = (i + 1) % n;
    int *next, *out, result = 0;
    cudaMalloc(&next, n * sizeof(int));
    cudaMalloc(&out, sizeof(int));
    cudaMemcpy(next, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    length<<<1, 1>>>(next, 0, out);
    cudaMemcpy(&result, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(next);
    cudaFree(out);
}
