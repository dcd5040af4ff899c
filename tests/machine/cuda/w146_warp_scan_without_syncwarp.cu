// expect: races,watch error 12|13 race
// A scan in shared memory that trusts that a warp runs in lock step.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void scan(int* x) {
    __shared__ int s[32];
    int t = threadIdx.x;
    s[t] = x[t];
    __syncwarp();
    for (int d = 1; d < 32; d *= 2) {
        int left = t >= d ? s[t - d] : 0;  // BUG
        s[t] += left;  // BUG: __syncwarp() is missing before and behind this line
    }
    x[t] = s[t];
}
int main() {
    std::vector<int> h(32, 1);
    int* x;
    cudaMalloc(&x, 32 * sizeof(int));
    cudaMemcpy(x, h.data(), 32 * sizeof(int), cudaMemcpyHostToDevice);
    scan<<<1, 32>>>(x);
    cudaMemcpy(h.data(), x, 32 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(x);
}
