// CUDA arrays: memory for textures and surfaces, which kernels reach through those alone.
//
// A GPU lays arrays out in its own way; here they are rows without gaps, and layers of rows.
#pragma once

#include "common/simt/runtime_memory.h"
#include "common/simt/vector_types.h"

#include <type_traits>

struct cudaExtent {
    size_t width, height, depth;
};
inline cudaExtent make_cudaExtent(size_t width, size_t height, size_t depth) {
    return {width, height, depth};
}

enum cudaChannelFormatKind {
    cudaChannelFormatKindSigned = 0,
    cudaChannelFormatKindUnsigned = 1,
    cudaChannelFormatKindFloat = 2,
    cudaChannelFormatKindNone = 3,
};
struct cudaChannelFormatDesc {
    int x, y, z, w; // bits of each channel
    cudaChannelFormatKind f;
};
inline cudaChannelFormatDesc cudaCreateChannelDesc(int x, int y, int z, int w,
                                                   cudaChannelFormatKind kind) {
    return {x, y, z, w, kind};
}

namespace raylab::simt {

// A vector type's element and how many it has; a number is a vector of one.
template <class T> struct Channels {
    using Element = T;
    static constexpr int count = 1;
};
template <class T>
requires requires(T v) { v.x; }
struct Channels<T> {
    using Element = decltype(T::x);
    static constexpr int count = int(sizeof(T) / sizeof(Element));
};

} // namespace raylab::simt

template <class T> inline cudaChannelFormatDesc cudaCreateChannelDesc() {
    using Element = typename raylab::simt::Channels<T>::Element;
    constexpr int count = raylab::simt::Channels<T>::count, bits = int(sizeof(Element)) * 8;
    auto kind = !std::is_integral_v<Element> ? cudaChannelFormatKindFloat
                : std::is_signed_v<Element>  ? cudaChannelFormatKindSigned
                                             : cudaChannelFormatKindUnsigned;
    return {bits, count > 1 ? bits : 0, count > 2 ? bits : 0, count > 3 ? bits : 0, kind};
}
inline cudaChannelFormatDesc cudaCreateChannelDescHalf() {
    return {16, 0, 0, 0, cudaChannelFormatKindFloat};
}

inline constexpr unsigned cudaArrayDefault = 0, cudaArrayLayered = 1, cudaArraySurfaceLoadStore = 2,
                          cudaArrayCubemap = 4, cudaArrayTextureGather = 8;

struct cudaArray {
    char* data;
    cudaChannelFormatDesc channels;
    cudaExtent extent; // in elements; 0 in the directions that the array lacks
    unsigned flags;
    size_t element_bytes() const {
        return size_t(channels.x + channels.y + channels.z + channels.w) / 8;
    }
    size_t row_bytes() const { return extent.width * element_bytes(); }
};
using cudaArray_t = cudaArray*;
using cudaArray_const_t = const cudaArray*;

cudaError_t cudaMallocArray(cudaArray_t* array, const cudaChannelFormatDesc* channels, size_t width,
                            size_t height = 0, unsigned flags = 0,
                            raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMalloc3DArray(cudaArray_t* array, const cudaChannelFormatDesc* channels,
                              cudaExtent extent, unsigned flags = 0,
                              raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaFreeArray(cudaArray_t array,
                          raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaArrayGetInfo(cudaChannelFormatDesc* channels, cudaExtent* extent, unsigned* flags,
                             cudaArray_t array);
cudaError_t cudaGetChannelDesc(cudaChannelFormatDesc* channels, cudaArray_const_t array);

// Offsets and widths in x are in bytes.
cudaError_t cudaMemcpy2DToArray(cudaArray_t to, size_t x, size_t y, const void* from, size_t pitch,
                                size_t width, size_t height, cudaMemcpyKind kind,
                                raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMemcpy2DFromArray(void* to, size_t pitch, cudaArray_const_t from, size_t x,
                                  size_t y, size_t width, size_t height, cudaMemcpyKind kind,
                                  raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMemcpyToArray(cudaArray_t to, size_t x, size_t y, const void* from, size_t bytes,
                              cudaMemcpyKind kind,
                              raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMemcpyFromArray(void* to, cudaArray_const_t from, size_t x, size_t y, size_t bytes,
                                cudaMemcpyKind kind,
                                raylab::simt::Where where = raylab::simt::Where::here());
