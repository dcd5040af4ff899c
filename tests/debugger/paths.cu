// Paths without a scene: 8 pixels, 3 bounces each, for the debugger's test.
#include "common/sampling/sampler.h"
#include "common/simt/cuda.h"

#include <cstdio>

using namespace raylab;

__device__ float bounces(const Sampler& sampler) {
    float sum = 0;
    for (int bounce = 0; bounce < 3; ++bounce) sum += sampler.get_bounce(bounce).lobe;
    return sum;
}

__global__ void trace_kernel(float* out, std::uint32_t sample) {
    const std::uint32_t pixel = blockIdx.x * blockDim.x + threadIdx.x;
    const Sampler sampler = {SamplerKind::sobol, 1, pixel, sample};
    out[pixel] += film_point(true, sampler).x + bounces(sampler);
}

int main() {
    float* sums = nullptr;
    cudaMalloc(&sums, 8 * sizeof(float));
    cudaMemset(sums, 0, 8 * sizeof(float));
    for (std::uint32_t sample = 0; sample < 2; ++sample) trace_kernel<<<2, 4>>>(sums, sample);
    const cudaError_t status = cudaDeviceSynchronize();
    cudaFree(sums);
    std::puts("done");
    return status == cudaSuccess ? 0 : 1;
}
