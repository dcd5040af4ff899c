// expect: nothing
// Each step reads one buffer and writes the other: one barrier a step is enough.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void scan(const int* in, int* out) {
    __shared__ int s[2][96];
    int t = threadIdx.x, now = 0;
    s[0][t] = in[t];
    __syncthreads();
    for (int d = 1; d < 96; d *= 2) {
        s[1 - now][t] = s[now][t] + (t >= d ? s[now][t - d] : 0);
        now = 1 - now;
        __syncthreads();
    }
    out[t] = s[now][t];
}
int main() {
    std::vector<int> h(96, 1);
    int *in, *out;
    cudaMalloc(&in, 96 * sizeof(int));
    cudaMalloc(&out, 96 * sizeof(int));
    cudaMemcpy(in, h.data(), 96 * sizeof(int), cudaMemcpyHostToDevice);
    scan<<<1, 96>>>(in, out);
    cudaMemcpy(h.data(), out, 96 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[95]);
    cudaFree(in);
    cudaFree(out);
    return h[95] != 96;
}
