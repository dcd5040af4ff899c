// expect: plain,bounds,races,watch,order error 8 bad-mask
// The mask names 16 lanes, but all 32 execute the shuffle.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void sums_of_16(const int* in, int* out) {
    int t = threadIdx.x, v = in[t];
    for (int d = 8; d > 0; d /= 2) v += __shfl_down_sync(0xffff, v, d, 16);  // BUG: lanes 16 to 31
    if (t % 16 == 0) out[t / 16] = v;
}
int main() {
    std::vector<int> h(64, 1);
    int *in, *out;
    cudaMalloc(&in, 64 * sizeof(int));
    cudaMalloc(&out, 4 * sizeof(int));
    cudaMemcpy(in, h.data(), 64 * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(out, 0, 4 * sizeof(int));
    sums_of_16<<<1, 64>>>(in, out);
    cudaMemcpy(h.data(), out, 4 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(in);
    cudaFree(out);
}
