// expect: nothing
// A list is built by atomicExch() of its head; the next kernel walks it, so no fence is needed.
#include <cuda_runtime.h>
#include <cstdio>
struct Node { int value, next; };
__global__ void push(Node* nodes, int* heads, int n, int buckets) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    nodes[i].value = i;
    nodes[i].next = atomicExch(&heads[i % buckets], i);
}
__global__ void sums(const Node* nodes, const int* heads, int* sum, int buckets) {
    int b = threadIdx.x;
    if (b >= buckets) return;
    int total = 0;
    for (int i = heads[b]; i >= 0; i = nodes[i].next) total += nodes[i].value;
    sum[b] = total;
}
int main() {
    const int n = 100, buckets = 10;
    Node* nodes;
    int *heads, *sum, h[buckets];
    cudaMalloc(&nodes, n * sizeof(Node));
    cudaMalloc(&heads, buckets * sizeof(int));
    cudaMalloc(&sum, buckets * sizeof(int));
    cudaMemset(heads, 0xff, buckets * sizeof(int));
    push<<<2, 64>>>(nodes, heads, n, buckets);
    sums<<<1, 32>>>(nodes, heads, sum, buckets);
    cudaMemcpy(h, sum, sizeof(h), cudaMemcpyDeviceToHost);
    printf("%d %d\n", h[0], h[9]);
    cudaFree(nodes);
    cudaFree(heads);
    cudaFree(sum);
    return h[0] != 450;
}
