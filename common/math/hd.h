// HD marks a function that both machines run: the GPU (nvcc) and the CPU (any host compiler).
#pragma once

#if defined(__CUDACC__)
#define HD __host__ __device__ inline
#else
#define HD inline
#endif
