// expect: nothing
// A filter whose weights are in constant memory, over an image read by a texture that clamps.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__constant__ float weights[3];
__global__ void filter(cudaTextureObject_t image, float* out, int w, int h) {
    int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y;
    if (x >= w || y >= h) return;
    float sum = 0;
    for (int k = -1; k <= 1; ++k) sum += weights[k + 1] * tex2D<float>(image, x + k + 0.5f, y + 0.5f);
    out[y * w + x] = sum;
}
int main() {
    const int w = 20, h = 12;
    std::vector<float> pixels(w * h, 8.f);
    const float weight[3] = {0.25f, 0.5f, 0.25f};
    cudaMemcpyToSymbol(weights, weight, sizeof(weight));
    cudaChannelFormatDesc channel = cudaCreateChannelDesc<float>();
    cudaArray_t array;
    cudaMallocArray(&array, &channel, w, h);
    cudaMemcpy2DToArray(array, 0, 0, pixels.data(), w * sizeof(float), w * sizeof(float), h,
                        cudaMemcpyHostToDevice);
    cudaResourceDesc resource = {};
    resource.resType = cudaResourceTypeArray;
    resource.res.array.array = array;
    cudaTextureDesc description = {};
    description.addressMode[0] = description.addressMode[1] = cudaAddressModeClamp;
    description.filterMode = cudaFilterModePoint;
    description.readMode = cudaReadModeElementType;
    cudaTextureObject_t texture = 0;
    cudaCreateTextureObject(&texture, &resource, &description, nullptr);
    float* out;
    cudaMalloc(&out, w * h * sizeof(float));
    filter<<<dim3(3, 2), dim3(8, 8)>>>(texture, out, w, h);
    cudaMemcpy(pixels.data(), out, w * h * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g %g\n", pixels[0], pixels[w * h - 1]);
    cudaDestroyTextureObject(texture);
    cudaFreeArray(array);
    cudaFree(out);
    return pixels[0] != 8;
}
