// expect: bounds,watch error 14 host-dereference|host-reads-device|host-writes-device
// The input is filled by the host, in device memory.
#include <cuda_runtime.h>
#include <cstdio>
struct Particle { float x, v; };
__global__ void step(Particle* p, int n, float dt) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) p[i].x += p[i].v * dt;
}
int main() {
    const int n = 64;
    Particle *p, first;
    cudaMalloc(&p, n * sizeof(Particle));
    for (int i = 0; i < n; ++i) p[i] = {0.f, float(i)};  // BUG: p is a device pointer
    step<<<1, n>>>(p, n, 0.1f);
    cudaMemcpy(&first, p, sizeof(Particle), cudaMemcpyDeviceToHost);
    printf("%g\n", first.x);
    cudaFree(p);
}
