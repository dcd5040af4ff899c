// Accesses whose sectors and bank conflicts are counted by hand: run_test.cpp holds `--machine memory` to them.
#include <cuda_runtime.h>
struct Body { float x, y, z, mass, vx, vy, vz, padding; };
__device__ float value(const float* p) {
    return *p; // line 5: inlined twice into twice()
}
__global__ void twice(const float* x, float* y) { y[threadIdx.x] = value(x + threadIdx.x) + value(x + 32 + threadIdx.x); }
__global__ void of_structs(const Body* bodies, float* y) {
    y[threadIdx.x] = bodies[threadIdx.x].x; // line 9: one sector a lane
}
__global__ void column(float* y) {
    __shared__ float tile[32][32];
    tile[threadIdx.x][0] = 1; // line 13: 32 words of one bank
    __syncthreads();
    y[threadIdx.x] = tile[0][0];
}
__global__ void half_of_the_lanes(float* y) {
    if (threadIdx.x < 16)
        y[threadIdx.x] = 1; // line 19
}
int main() {
    float* x;
    Body* bodies;
    cudaMalloc(&x, 4096);
    cudaMalloc(&bodies, 32 * sizeof(Body));
    cudaMemset(x, 0, 4096);
    cudaMemset(bodies, 0, 32 * sizeof(Body));
    twice<<<1, 32>>>(x, x + 512);
    of_structs<<<1, 32>>>(bodies, x);
    column<<<1, 32>>>(x);
    half_of_the_lanes<<<1, 32>>>(x);
    cudaFree(x);
    cudaFree(bodies);
    return 0;
}
