// expect: watch error 20 host-reads-device|host-writes-device|host-dereference
// A __constant__ variable is set by an assignment of the host.
#include <cuda_runtime.h>
#include <cstdio>
struct Settings { float gravity, dt; int steps; };
__constant__ Settings settings;
__global__ void fall(float* height, float* speed) {
    int i = threadIdx.x;
    for (int s = 0; s < settings.steps; ++s) {
        speed[i] -= settings.gravity * settings.dt;
        height[i] += speed[i] * settings.dt;
    }
}
int main() {
    float *height, *speed, first;
    cudaMalloc(&height, 32 * sizeof(float));
    cudaMalloc(&speed, 32 * sizeof(float));
    cudaMemset(height, 0, 32 * sizeof(float));
    cudaMemset(speed, 0, 32 * sizeof(float));
    settings = {9.81f, 0.01f, 10};  // BUG: cudaMemcpyToSymbol()
    fall<<<1, 32>>>(height, speed);
    cudaMemcpy(&first, height, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaFree(height);
    cudaFree(speed);
}
