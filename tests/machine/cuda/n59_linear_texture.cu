// expect: nothing
// A texture over linear memory, of floats and of integers.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void gather(cudaTextureObject_t table, cudaTextureObject_t order, float* out) {
    out[threadIdx.x] = tex1Dfetch<float>(table, tex1Dfetch<int>(order, threadIdx.x));
}
template <class T> cudaTextureObject_t texture_of(T* memory, int n) {
    cudaResourceDesc resource = {};
    resource.resType = cudaResourceTypeLinear;
    resource.res.linear.devPtr = memory;
    resource.res.linear.desc = cudaCreateChannelDesc<T>();
    resource.res.linear.sizeInBytes = n * sizeof(T);
    cudaTextureDesc description = {};
    description.readMode = cudaReadModeElementType;
    cudaTextureObject_t texture = 0;
    cudaCreateTextureObject(&texture, &resource, &description, nullptr);
    return texture;
}
int main() {
    const int n = 64;
    std::vector<float> h(n);
    std::vector<int> reversed(n);
    for (int i = 0; i < n; ++i) h[i] = i, reversed[i] = n - 1 - i;
    float *x, *out;
    int* order;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&out, n * sizeof(float));
    cudaMalloc(&order, n * sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemcpy(order, reversed.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaTextureObject_t table = texture_of(x, n), places = texture_of(order, n);
    gather<<<1, n>>>(table, places, out);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaDestroyTextureObject(table);
    cudaDestroyTextureObject(places);
    cudaFree(x);
    cudaFree(out);
    cudaFree(order);
    return h[0] != n - 1;
}
