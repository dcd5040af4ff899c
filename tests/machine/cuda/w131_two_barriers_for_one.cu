// expect: plain,bounds,races,watch,order error 10|13 divergent-barrier
// Even and odd threads wait at different barriers.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void exchange(int* x) {
    __shared__ int s[64];
    int t = threadIdx.x;
    if (t % 2 == 0) {
        s[t] = x[t];
        __syncthreads();  // BUG
    } else {
        s[t] = -x[t];
        __syncthreads();  // BUG
    }
    x[t] = s[t ^ 1];
}
int main() {
    int *x, first = 0;
    cudaMalloc(&x, 64 * sizeof(int));
    cudaMemset(x, 0, 64 * sizeof(int));
    exchange<<<1, 64>>>(x);
    cudaMemcpy(&first, x, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first);
    cudaFree(x);
}
