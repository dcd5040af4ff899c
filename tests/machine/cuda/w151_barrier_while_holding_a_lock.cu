// expect: plain,bounds,races,watch,order error 9|12 endless-loop|deadlock
// One thread has the lock and waits at the barrier for threads that wait for the lock.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void update(int* total, int* lock) {
    __shared__ int s;
    if (threadIdx.x == 0) s = 0;
    __syncthreads();
    while (atomicCAS(lock, 0, 1) != 0) {  // BUG
    }
    s += 1;
    __syncthreads();  // BUG: within the lock
    *total = s;
    __threadfence();
    atomicExch(lock, 0);
}
int main() {
    int *total, *lock, result = 0;
    cudaMalloc(&total, sizeof(int));
    cudaMalloc(&lock, sizeof(int));
    cudaMemset(total, 0, sizeof(int));
    cudaMemset(lock, 0, sizeof(int));
    update<<<1, 64>>>(total, lock);
    cudaMemcpy(&result, total, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(total);
    cudaFree(lock);
}
