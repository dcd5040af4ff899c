// expect: watch error 8|10 foreign-local
// A thread publishes the address of its local variable; for another it means something else.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void share(int* out) {
    __shared__ int* mailbox;
    int local = threadIdx.x + 100;
    if (threadIdx.x == 0) mailbox = &local;  // BUG: local memory is each thread's own
    __syncthreads();
    out[threadIdx.x] = *mailbox;  // BUG
}
int main() {
    int *out, last = 0;
    cudaMalloc(&out, 64 * sizeof(int));
    share<<<1, 64>>>(out);
    cudaMemcpy(&last, out + 63, sizeof(int), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(out);
}
