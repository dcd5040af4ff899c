// HD marks a function that both machines run: the GPU (nvcc) and the CPU (any host compiler).
#pragma once

// nvcc, or an editor's clang, which defines __CUDA__ (common/simt/editor.h).
#if defined(__CUDACC__) || defined(__CUDA__)
#define RAYLAB_READS_CUDA
#endif

#if defined(RAYLAB_READS_CUDA)
#define HD __host__ __device__ inline
#else
#define HD inline
#endif

// HD_HOT: the same for functions that run once a ray or more. They are inlined even where a host
// compiler would call them: a struct that is written to memory in pieces and read as a whole stalls
// a CPU. Under a sanitizer they are not, because its checks make compilers slow on large functions.
#if defined(__GNUC__) && !defined(RAYLAB_READS_CUDA) && !defined(__SANITIZE_ADDRESS__) &&          \
    !defined(__SANITIZE_THREAD__)
#define HD_HOT __attribute__((always_inline)) inline
#else
#define HD_HOT HD
#endif

// HD_RARE: the same for functions that hardly ever run. A host compiler does not inline them, so
// that the loops which call them keep their registers.
#if defined(__GNUC__) && !defined(RAYLAB_READS_CUDA)
#define HD_RARE __attribute__((noinline)) inline
#else
#define HD_RARE HD
#endif
