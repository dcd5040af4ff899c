// Who am I: threadIdx, blockIdx, blockDim, gridDim, warpSize.
//
// Each worker has its own copy, which the engine sets before it runs or resumes a CUDA thread.
// constinit lets the compiler read them in one instruction, without asking for initialisation.
#pragma once

#include "common/simt/vector_types.h"

// Extents of a grid (in blocks) or of a block (in threads).
struct dim3 {
    unsigned x, y, z;
    constexpr dim3(unsigned x = 1, unsigned y = 1, unsigned z = 1) : x(x), y(y), z(z) {}
    constexpr dim3(uint3 v) : x(v.x), y(v.y), z(v.z) {}
    constexpr operator uint3() const { return {x, y, z}; }
};

#if defined(__CUDA__) // an editor's clang (editor.h): no variable of a device is a thread's
extern __attribute__((device)) const uint3 threadIdx, blockIdx;
extern __attribute__((device)) const dim3 blockDim, gridDim;
#else
inline constinit thread_local uint3 threadIdx{};
inline constinit thread_local uint3 blockIdx{};
inline constinit thread_local dim3 blockDim{};
inline constinit thread_local dim3 gridDim{};
#endif
inline constexpr int warpSize = 32;
