// expect: nothing
// Managed memory in the hands of the host, of a kernel, and of the host again.
#include <cuda_runtime.h>
#include <cstdio>
struct Node { int value; Node* next; };
__global__ void add(Node* head, int by) {
    if (threadIdx.x == 0)
        for (Node* node = head; node; node = node->next) node->value += by;
}
int main() {
    Node* nodes;
    cudaMallocManaged(&nodes, 10 * sizeof(Node));
    for (int i = 0; i < 10; ++i) nodes[i] = {i, i < 9 ? &nodes[i + 1] : nullptr};
    add<<<1, 32>>>(nodes, 5);
    cudaDeviceSynchronize();
    for (int i = 0; i < 10; ++i) nodes[i].value *= 2;
    add<<<1, 32>>>(nodes, 1);
    cudaStreamSynchronize(0);
    printf("%d\n", nodes[9].value);
    const bool right = nodes[9].value == 29;
    cudaFree(nodes);
    return !right;
}
