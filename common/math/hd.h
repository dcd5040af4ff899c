// HD marks a function that both machines run: the GPU (nvcc) and the CPU (any host compiler).
#pragma once

#if defined(__CUDACC__)
#define HD __host__ __device__ inline
#else
#define HD inline
#endif

// HD_HOT: the same for what runs once a ray or more. It is inlined even where a host compiler would
// rather call it: structs that pass through memory, written in pieces and read whole, stall a CPU.
// Not under a sanitizer, whose checks make compilers slow on large functions.
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__SANITIZE_ADDRESS__) &&                 \
    !defined(__SANITIZE_THREAD__)
#define HD_HOT __attribute__((always_inline)) inline
#else
#define HD_HOT HD
#endif

// HD_RARE: the same for what hardly ever runs. A host compiler keeps it out of the loops that might
// call it, which need the registers.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define HD_RARE __attribute__((noinline)) inline
#else
#define HD_RARE HD
#endif
