// The scene's shapes in shared memory: "if the scene is sufficiently small, cache geometry data in
// shared memory".
//
// Every ray tests every shape, so all threads of a block read the same few kilobytes again and
// again. The block copies them once into shared memory, which is much faster. "Why might this be a
// bad idea in some cases?" Each block needs a copy of its own. The copies leave less room for other
// blocks, and with fewer warps to choose from a multiprocessor waits longer.
#pragma once

#include "common/math/features.h"
#include "common/scene/view.h"
#include "common/simt/cuda.h"
#include "common/task/not_implemented.h"

namespace raylab::lab03 {

// What a block may have without asking for more (cudaFuncAttributeMaxDynamicSharedMemorySize).
constexpr std::size_t shared_memory_limit = 48 << 10;

constexpr std::size_t rounded_up(std::size_t bytes) { return (bytes + 15) / 16 * 16; }

template <class T> std::size_t shared_bytes(const Array<T>& array) {
    return rounded_up(array.size * sizeof(T));
}

// What the shapes take in shared memory.
inline std::size_t geometry_bytes(const SceneView& scene) {
    return shared_bytes(scene.spheres) + shared_bytes(scene.sphere_groups) +
           shared_bytes(scene.quads) + shared_bytes(scene.quad_groups) +
           shared_bytes(scene.planes) + shared_bytes(scene.triangles) + shared_bytes(scene.runs);
}

// Copies the array to `free` by all threads of the block, points it there, and moves `free` on.
template <class T> __device__ void move_to_shared(Array<T>& array, unsigned char*& free) {
    static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
    const auto* from = reinterpret_cast<const std::uint32_t*>(array.data);
    auto* to = reinterpret_cast<std::uint32_t*>(free);
    const int words = static_cast<int>(array.size * sizeof(T) / sizeof(std::uint32_t));
    for (int i = static_cast<int>(threadIdx.x); i < words; i += static_cast<int>(blockDim.x))
        to[i] = from[i];
    array.data = reinterpret_cast<const T*>(free);
    free += rounded_up(array.size * sizeof(T));
}

// The scene with its shapes in `memory`, geometry_bytes() of the block's shared memory. All threads
// of the block must call it, and wait for each other before they use it.
template <Features F>
__device__ SceneView geometry_in_shared_memory(SceneView scene, void* memory) {
    // Steps:
    // 1. What is free begins at `memory`, as bytes.
    // 2. Move each array that F has, one after the other: spheres and their groups, quads and their
    //    groups, planes, triangles and their runs. move_to_shared() moves what is free on.
    //[ task 3.5
    auto* free = static_cast<unsigned char*>(memory);
    if constexpr (F & feature::sphere) move_to_shared(scene.spheres, free);
    if constexpr (F & feature::sphere) move_to_shared(scene.sphere_groups, free);
    if constexpr (F & feature::quad) move_to_shared(scene.quads, free);
    if constexpr (F & feature::quad) move_to_shared(scene.quad_groups, free);
    if constexpr (F & feature::plane) move_to_shared(scene.planes, free);
    if constexpr (F & feature::triangle) move_to_shared(scene.triangles, free);
    if constexpr (F & feature::triangle) move_to_shared(scene.runs, free);
    //| not_implemented("3.5", "geometry_in_shared_memory()");
    //]
    return scene;
}

} // namespace raylab::lab03
