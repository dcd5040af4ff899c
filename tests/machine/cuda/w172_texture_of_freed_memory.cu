// expect: bounds,watch error 7 use-after-free|out-of-bounds
// The memory under a texture is freed before the kernel that fetches.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void gather(cudaTextureObject_t table, float* out) {
    out[threadIdx.x] = tex1Dfetch<float>(table, 63 - threadIdx.x);  // BUG
}
int main() {
    const int n = 64;
    std::vector<float> h(n, 2.f);
    float *memory, *out;
    cudaMalloc(&memory, n * sizeof(float));
    cudaMalloc(&out, n * sizeof(float));
    cudaMemcpy(memory, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaResourceDesc resource = {};
    resource.resType = cudaResourceTypeLinear;
    resource.res.linear.devPtr = memory;
    resource.res.linear.desc = cudaCreateChannelDesc<float>();
    resource.res.linear.sizeInBytes = n * sizeof(float);
    cudaTextureDesc description = {};
    description.readMode = cudaReadModeElementType;
    cudaTextureObject_t texture = 0;
    cudaCreateTextureObject(&texture, &resource, &description, nullptr);
    cudaFree(memory);
    gather<<<1, n>>>(texture, out);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%d\n", int(h.size()));
    cudaDestroyTextureObject(texture);
    cudaFree(out);
}
