// expect: plain,bounds,races,watch,order error 14 exit-before-barrier|divergent-barrier
// The barrier of a reduction slipped into the branch.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void sum(const int* in, int* out) {
    __shared__ int s[128];
    int t = threadIdx.x;
    s[t] = in[t];
    __syncthreads();
    for (int d = 64; d > 0; d /= 2) {
        if (t < d) {
            s[t] += s[t + d];
            __syncthreads();  // BUG: threads from d on do not come
        }
    }
    if (t == 0) *out = s[0];
}
int main() {
    std::vector<int> h(128, 1);
    int *in, *out, result = 0;
    cudaMalloc(&in, 128 * sizeof(int));
    cudaMalloc(&out, sizeof(int));
    cudaMemcpy(in, h.data(), 128 * sizeof(int), cudaMemcpyHostToDevice);
    sum<<<1, 128>>>(in, out);
    cudaMemcpy(&result, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(in);
    cudaFree(out);
}
