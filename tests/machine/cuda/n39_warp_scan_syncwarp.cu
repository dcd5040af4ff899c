// expect: nothing
// A scan of a warp in shared memory, with __syncwarp() between reading and writing.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void scan(int* x) {
    __shared__ int s[64];
    int t = threadIdx.x, lane = t % 32;
    s[t] = x[t];
    __syncwarp();
    for (int d = 1; d < 32; d *= 2) {
        int left = lane >= d ? s[t - d] : 0;
        __syncwarp();
        s[t] += left;
        __syncwarp();
    }
    __syncthreads();
    x[t] = s[t] + (t >= 32 ? s[31] : 0);
}
int main() {
    int h[64], *x;
    for (int i = 0; i < 64; ++i) h[i] = 1;
    cudaMalloc(&x, sizeof(h));
    cudaMemcpy(x, h, sizeof(h), cudaMemcpyHostToDevice);
    scan<<<1, 64>>>(x);
    cudaMemcpy(h, x, sizeof(h), cudaMemcpyDeviceToHost);
    printf("%d\n", h[63]);
    cudaFree(x);
    return h[63] != 64;
}
