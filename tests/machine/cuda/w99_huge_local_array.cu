// expect: plain,bounds,races,watch,order error 5|7 stack-overflow
// A local array of 800 kB: a thread has at most 512 kB of local memory.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void sieve(int* primes, int n) {  // BUG
    bool composite[800000];
    for (int i = 0; i < n; ++i) composite[i] = false;  // BUG
    int found = 0;
    for (int i = 2; i < n; ++i) {
        if (composite[i]) continue;
        ++found;
        for (int j = 2 * i; j < n; j += i) composite[j] = true;
    }
    primes[threadIdx.x] = found;
}
int main() {
    int* primes;
    cudaMalloc(&primes, sizeof(int));
    sieve<<<1, 1>>>(primes, 800000);
    int found = 0;
    cudaMemcpy(&found, primes, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", found);
    cudaFree(primes);
}
