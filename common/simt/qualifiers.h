// CUDA's qualifiers, in the host compiler's words.
//
// Host and device share one memory here, so most of them say nothing. `__shared__` says that a
// variable is the block's: a worker runs one block at a time, so the worker's own copy will do.
// AddressSanitizer does not see the bounds of thread-local arrays, hence its build has one worker
// and plain statics. A worker is one operating system thread for as long as its block runs.
#pragma once

#if defined(RAYLAB_CHECK_WATCH) // which must know them from variables of host code
#define __managed__ __attribute__((section("raylab_managed")))
#else
#define __managed__
#endif
#define __grid_constant__
#define __forceinline__ inline __attribute__((always_inline))
#define __align__(bytes) __attribute__((aligned(bytes)))

#if defined(__CUDA__) // an editor's clang, which knows CUDA (editor.h)
#define __global__ __attribute__((global))
#define __device__ __attribute__((device))
#define __host__ __attribute__((host))
#define __constant__ __attribute__((constant))
#define __shared__ __attribute__((shared))
#define __launch_bounds__(...) __attribute__((launch_bounds(__VA_ARGS__)))
#else
#define __global__
#define __device__
#define __host__
#define __constant__
#define __launch_bounds__(...)
#if defined(RAYLAB_CHECK_ADDRESS)
#define __shared__ static
#else
#define __shared__ static thread_local
#endif
#endif
