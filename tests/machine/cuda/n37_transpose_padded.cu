// expect: nothing
// A transpose by tiles with a padded column, for a matrix that fills no whole number of tiles.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
#define TILE 16
__global__ void transpose(const float* in, float* out, int w, int h) {
    __shared__ float tile[TILE][TILE + 1];
    int x = blockIdx.x * TILE + threadIdx.x, y = blockIdx.y * TILE + threadIdx.y;
    if (x < w && y < h) tile[threadIdx.y][threadIdx.x] = in[y * w + x];
    __syncthreads();
    x = blockIdx.y * TILE + threadIdx.x;
    y = blockIdx.x * TILE + threadIdx.y;
    if (x < h && y < w) out[y * h + x] = tile[threadIdx.x][threadIdx.y];
}
int main() {
    const int w = 40, h = 23;
    std::vector<float> m(w * h), t(w * h);
    for (int i = 0; i < w * h; ++i) m[i] = i;
    float *in, *out;
    cudaMalloc(&in, w * h * sizeof(float));
    cudaMalloc(&out, w * h * sizeof(float));
    cudaMemcpy(in, m.data(), w * h * sizeof(float), cudaMemcpyHostToDevice);
    transpose<<<dim3((w + TILE - 1) / TILE, (h + TILE - 1) / TILE), dim3(TILE, TILE)>>>(in, out, w, h);
    cudaMemcpy(t.data(), out, w * h * sizeof(float), cudaMemcpyDeviceToHost);
    bool right = true;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) right &= t[x * h + y] == m[y * w + x];
    printf("%s\n", right ? "right" : "wrong");
    cudaFree(in);
    cudaFree(out);
    return !right;
}
