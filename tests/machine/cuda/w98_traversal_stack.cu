// expect: bounds,watch error 15 index-out-of-bounds; maybe error 12 index-out-of-bounds
// A walk through a tree with a stack of its own, which is one element too small for this tree.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
struct Node { int left, right; float value; };
__global__ void sum_tree(const Node* nodes, float* out) {
    int stack[8], size = 0;
    stack[size++] = 0;
    float sum = 0;
    while (size > 0) {
        const Node node = nodes[stack[--size]];
        sum += node.value;
        if (node.left >= 0) stack[size++] = node.left;
        if (node.right >= 0) stack[size++] = node.right;  // BUG: 8 levels need 9 elements
    }
    out[threadIdx.x] = sum;
}
int main() {
    std::vector<Node> h;  // each left child is a leaf: they all wait on the stack
    const int levels = 8;
    for (int i = 0; i < levels; ++i) h.push_back({levels + i, i + 1 < levels ? i + 1 : 2 * levels, 1.f});
    for (int i = 0; i <= levels; ++i) h.push_back({-1, -1, 1.f});
    Node* nodes;
    float* out;
    cudaMalloc(&nodes, h.size() * sizeof(Node));
    cudaMalloc(&out, 32 * sizeof(float));
    cudaMemcpy(nodes, h.data(), h.size() * sizeof(Node), cudaMemcpyHostToDevice);
    sum_tree<<<1, 32>>>(nodes, out);
    float first;
    cudaMemcpy(&first, out, sizeof(float), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(nodes);
    cudaFree(out);
}
