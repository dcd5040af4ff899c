// expect: races,watch error 18|19 race; maybe error 21 race
// The memory of one phase becomes that of the next while slow threads still read it.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
union Scratch {
    float values[64];
    int ranks[64];
};
__global__ void rank_sort(float* x) {
    __shared__ Scratch s;
    int t = threadIdx.x;
    float mine = x[t];
    s.values[t] = mine;
    __syncthreads();
    int rank = 0;
    for (int i = 0; i < 64; ++i)
        rank += s.values[i] < mine || (s.values[i] == mine && i < t);  // BUG
    s.ranks[t] = rank;  // BUG: a barrier is missing before this line
    __syncthreads();
    if (s.ranks[t] >= 0 && s.ranks[t] < 64) x[s.ranks[t]] = mine;
}
int main() {
    std::vector<float> h(64);
    for (int i = 0; i < 64; ++i) h[i] = (i * 29) % 64;
    float* x;
    cudaMalloc(&x, 64 * sizeof(float));
    cudaMemcpy(x, h.data(), 64 * sizeof(float), cudaMemcpyHostToDevice);
    rank_sort<<<1, 64>>>(x);
    cudaMemcpy(h.data(), x, 64 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(x);
}
