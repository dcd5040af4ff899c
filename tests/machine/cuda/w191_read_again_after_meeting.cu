// expect: races,watch error 14|16 race
// Lane 0 reads a value, the lanes meet, and it reads the value again while another already changes it.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void relax(float* x) {
    __shared__ float best;
    int t = threadIdx.x;
    if (t == 0) best = x[0];
    __syncthreads();
    float mine = x[t];
    if (t == 0) mine -= best;
    __syncwarp();
    if (t == 0)
        mine = mine * x[32] + best;  // BUG: the second read is not before the meeting
    if (t == 1)
        best = mine;  // BUG
    x[t] = mine;
}
int main() {
    float* x;
    cudaMalloc(&x, 33 * sizeof(float));
    cudaMemset(x, 0, 33 * sizeof(float));
    relax<<<1, 32>>>(x);
    printf("%d\n", cudaDeviceSynchronize());
    cudaFree(x);
}
