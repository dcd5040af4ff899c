// expect: races,watch error 7|9|12|13 race; maybe error 13 endless-loop
// A block waits for another one's flag, which is an ordinary variable.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void pipeline(int* data, int* ready, int* out) {
    if (blockIdx.x == 0) {
        data[threadIdx.x] = threadIdx.x + 1;  // BUG
        __syncthreads();
        if (threadIdx.x == 0) *ready = 1;  // BUG: neither atomic nor behind a fence
    } else {
        int tries = 0;
        while (*ready == 0 && tries < 1000000) ++tries;  // BUG: may be read once only
        out[threadIdx.x] = data[threadIdx.x];  // BUG
    }
}
int main() {
    int *memory, first = 0;
    cudaMalloc(&memory, 65 * sizeof(int));
    cudaMemset(memory, 0, 65 * sizeof(int));
    pipeline<<<2, 32>>>(memory, memory + 64, memory + 32);
    cudaMemcpy(&first, memory + 32, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first >= 0);
    cudaFree(memory);
}
