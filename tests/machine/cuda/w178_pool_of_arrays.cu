// expect: bounds,watch error 11 out-of-bounds
// x, y and z of particles lie one behind the other in a pool, and z begins too late.
#include <cuda_runtime.h>
#include <cstdio>
struct Particles {
    float *x, *y, *z;
    int n;
};
__global__ void drop(Particles p, float g) {
    for (int i = blockIdx.x * blockDim.x + threadIdx.x; i < p.n; i += gridDim.x * blockDim.x)
        p.z[i] = p.x[i] + p.y[i] - g;  // BUG: z begins at 2 * n, not 3 * n
}
int main() {
    const int n = 100;
    float *pool, last;
    cudaMalloc(&pool, 3 * n * sizeof(float));
    cudaMemset(pool, 0, 3 * n * sizeof(float));
    Particles p{pool, pool + n, pool + 3 * n, n};
    drop<<<1, 64>>>(p, 9.81f);
    cudaMemcpy(&last, pool + 2 * n, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", last);
    cudaFree(pool);
}
