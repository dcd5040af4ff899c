// expect: plain,bounds,races,watch,order error 13 bad-copy
// The count of results was multiplied by the size of the element twice.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void cubes(int* x) { x[threadIdx.x] = threadIdx.x * threadIdx.x * threadIdx.x; }
int main() {
    const size_t bytes = 64 * sizeof(int);
    std::vector<int> h(1024);
    int* x;
    cudaMalloc(&x, bytes);
    cubes<<<1, 64>>>(x);
    cudaMemcpy(h.data(), x, bytes * sizeof(int), cudaMemcpyDeviceToHost);  // BUG: bytes
    printf("%d\n", h[3]);
    cudaFree(x);
}
