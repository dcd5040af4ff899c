// expect: nothing
// A stable compaction of one block: votes give places within warps, a scan those of warps.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void compact(const int* in, int n, int* out, int* count) {
    __shared__ int start[4];
    int t = threadIdx.x, lane = t % 32, warp = t / 32;
    bool keep = t < n && in[t] % 3 == 0;
    unsigned votes = __ballot_sync(0xffffffff, keep);
    if (lane == 0) start[warp] = __popc(votes);
    __syncthreads();
    if (t == 0) {
        int sum = 0;
        for (int w = 0; w < 4; ++w) {
            int size = start[w];
            start[w] = sum;
            sum += size;
        }
        *count = sum;
    }
    __syncthreads();
    if (keep) out[start[warp] + __popc(votes & ((1u << lane) - 1))] = in[t];
}
int main() {
    const int n = 110;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    int *in, *out, *count, kept;
    cudaMalloc(&in, n * sizeof(int));
    cudaMalloc(&out, n * sizeof(int));
    cudaMalloc(&count, sizeof(int));
    cudaMemcpy(in, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    compact<<<1, 128>>>(in, n, out, count);
    cudaMemcpy(&kept, count, sizeof(int), cudaMemcpyDeviceToHost);
    cudaMemcpy(h.data(), out, kept * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d: %d %d\n", kept, h[1], h[kept - 1]);
    cudaFree(in);
    cudaFree(out);
    cudaFree(count);
}
