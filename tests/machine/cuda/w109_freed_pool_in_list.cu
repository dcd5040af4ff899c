// expect: bounds,watch error 13 use-after-free
// The nodes of a list lie in two pools; the second is freed while the first points into it.
#include <cuda_runtime.h>
#include <cstdio>
struct Node { int value; Node* next; };
__global__ void build(Node* a, Node* b) {
    a[0] = {1, &b[0]};
    b[0] = {2, &a[1]};
    a[1] = {3, nullptr};
}
__global__ void sum(const Node* head, int* out) {
    int total = 0;
    for (const Node* node = head; node; node = node->next) total += node->value;  // BUG: b is freed
    *out = total;
}
int main() {
    Node *a, *b;
    int *out, total = 0;
    cudaMalloc(&a, 2 * sizeof(Node));
    cudaMalloc(&b, sizeof(Node));
    cudaMalloc(&out, sizeof(int));
    build<<<1, 1>>>(a, b);
    cudaDeviceSynchronize();
    cudaFree(b);
    sum<<<1, 1>>>(a, out);
    cudaMemcpy(&total, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", total);
    cudaFree(a);
    cudaFree(out);
}
