// expect: races,watch error 12|13 race
// Two buffers in shared memory, but no barrier between one step and the next.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void relax(float* x, int steps) {
    __shared__ float s[2][96];
    int t = threadIdx.x, now = 0;
    s[0][t] = x[t];
    __syncthreads();
    for (int i = 0; i < steps; ++i) {
        float left = t > 0 ? s[now][t - 1] : 0, right = t < 95 ? s[now][t + 1] : 0;  // BUG
        s[1 - now][t] = 0.5f * (left + right);  // BUG: a barrier is missing behind this line
        now = 1 - now;
    }
    x[t] = s[now][t];
}
int main() {
    std::vector<float> h(96, 1.f);
    float* x;
    cudaMalloc(&x, 96 * sizeof(float));
    cudaMemcpy(x, h.data(), 96 * sizeof(float), cudaMemcpyHostToDevice);
    relax<<<1, 96>>>(x, 5);
    cudaMemcpy(h.data(), x, 96 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0] < 1);
    cudaFree(x);
}
