// expect: races,watch error 12|18|21 race; maybe error 13 exit-before-barrier
// The flag "something changed" is read at the end of one round and reset at the start of the next.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void propagate(int* label) {
    __shared__ int s[64];
    __shared__ int changed;
    int t = threadIdx.x;
    s[t] = label[t];
    do {
        if (t == 0) changed = 0;  // BUG: others may still be at the condition of the last round
        __syncthreads();
        int least = t > 0 ? min(s[t], s[t - 1]) : s[t];
        __syncthreads();
        if (least < s[t]) {
            s[t] = least;
            changed = 1;  // BUG
        }
        __syncthreads();
    } while (changed);  // BUG
    label[t] = s[t];
}
int main() {
    std::vector<int> h(64);
    for (int i = 0; i < 64; ++i) h[i] = (i * 37) % 64;
    int* label;
    cudaMalloc(&label, 64 * sizeof(int));
    cudaMemcpy(label, h.data(), 64 * sizeof(int), cudaMemcpyHostToDevice);
    propagate<<<1, 64>>>(label);
    cudaMemcpy(h.data(), label, 64 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(label);
}
