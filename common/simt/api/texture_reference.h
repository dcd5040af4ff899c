// Texture references, which CUDA 12 has given up and books still use: a global variable of the type
// texture<T, dimensions, mode> that is bound to memory. The rewriter puts raylab's name in place of
// `texture`, which programs for later versions call things of their own.
#pragma once

#include "common/simt/api/texture_fetch.h"

inline constexpr int cudaTextureType1D = 1, cudaTextureType2D = 2, cudaTextureType3D = 3;

struct textureReference {
    int normalized = 0;
    cudaTextureFilterMode filterMode = cudaFilterModePoint;
    cudaTextureAddressMode addressMode[3] = {cudaAddressModeClamp, cudaAddressModeClamp,
                                             cudaAddressModeClamp};
    cudaChannelFormatDesc channelDesc{};
    cudaTextureObject_t object = 0;
};

namespace raylab::simt {

template <class T, int dimensions = 1, cudaTextureReadMode mode = cudaReadModeElementType>
struct TextureReference : textureReference {
    explicit TextureReference(int normalised = 0,
                              cudaTextureFilterMode filter = cudaFilterModePoint,
                              cudaTextureAddressMode address = cudaAddressModeClamp) {
        normalized = normalised;
        filterMode = filter;
        for (auto& axis : addressMode) axis = address;
        channelDesc = cudaCreateChannelDesc<T>();
    }
};

// What a fetch gives: the texel, or floats between 0 and 1 for it.
template <class T, cudaTextureReadMode mode> struct Fetched { using Type = T; };
template <> struct Fetched<unsigned char, cudaReadModeNormalizedFloat> { using Type = float; };
template <> struct Fetched<unsigned short, cudaReadModeNormalizedFloat> { using Type = float; };
template <> struct Fetched<uchar4, cudaReadModeNormalizedFloat> { using Type = float4; };

template <class T, int dimensions, cudaTextureReadMode mode>
inline cudaError_t bind(const raylab::simt::TextureReference<T, dimensions, mode>& reference,
                        const cudaResourceDesc& resource, Where where) {
    auto& self = const_cast<raylab::simt::TextureReference<T, dimensions, mode>&>(
        reference); // as CUDA's bind functions
    cudaTextureDesc description{};
    for (int i = 0; i < 3; ++i) description.addressMode[i] = self.addressMode[i];
    description.filterMode = self.filterMode;
    description.readMode = mode;
    description.normalizedCoords = self.normalized;
    cudaDestroyTextureObject(self.object);
    self.object = 0;
    return cudaCreateTextureObject(&self.object, &resource, &description, nullptr, where);
}

} // namespace raylab::simt

template <class T, int dimensions, cudaTextureReadMode mode>
inline cudaError_t cudaBindTexture(
    size_t* offset, const raylab::simt::TextureReference<T, dimensions, mode>& reference,
    const void* memory, const cudaChannelFormatDesc& channels, size_t bytes = 0x7fffffff,
    raylab::simt::Where where = raylab::simt::Where::here()) {
    if (offset) *offset = 0;
    cudaResourceDesc resource{};
    resource.resType = cudaResourceTypeLinear;
    resource.res.linear = {const_cast<void*>(memory), channels, bytes};
    return raylab::simt::bind(reference, resource, where);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline cudaError_t
cudaBindTexture(size_t* offset,
                const raylab::simt::TextureReference<T, dimensions, mode>& reference,
                const void* memory, size_t bytes = 0x7fffffff,
                raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaBindTexture(offset, reference, memory, cudaCreateChannelDesc<T>(), bytes, where);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline cudaError_t cudaBindTexture2D(
    size_t* offset, const raylab::simt::TextureReference<T, dimensions, mode>& reference,
    const void* memory, const cudaChannelFormatDesc& channels, size_t width, size_t height,
    size_t pitch, raylab::simt::Where where = raylab::simt::Where::here()) {
    if (offset) *offset = 0;
    cudaResourceDesc resource{};
    resource.resType = cudaResourceTypePitch2D;
    resource.res.pitch2D = {const_cast<void*>(memory), channels, width, height, pitch};
    return raylab::simt::bind(reference, resource, where);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline cudaError_t
cudaBindTextureToArray(const raylab::simt::TextureReference<T, dimensions, mode>& reference,
                       cudaArray_const_t array, const cudaChannelFormatDesc&,
                       raylab::simt::Where where = raylab::simt::Where::here()) {
    cudaResourceDesc resource{};
    resource.resType = cudaResourceTypeArray;
    resource.res.array.array = const_cast<cudaArray_t>(array);
    return raylab::simt::bind(reference, resource, where);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline cudaError_t
cudaBindTextureToArray(const raylab::simt::TextureReference<T, dimensions, mode>& reference,
                       cudaArray_const_t array,
                       raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaBindTextureToArray(reference, array, array->channels, where);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline cudaError_t
cudaUnbindTexture(const raylab::simt::TextureReference<T, dimensions, mode>& reference) {
    auto& self = const_cast<raylab::simt::TextureReference<T, dimensions, mode>&>(reference);
    cudaError_t error = cudaDestroyTextureObject(self.object);
    self.object = 0;
    return error;
}

template <class T, int dimensions, cudaTextureReadMode mode>
inline auto tex1Dfetch(const raylab::simt::TextureReference<T, dimensions, mode>& reference,
                       int x) {
    return tex1Dfetch<typename raylab::simt::Fetched<T, mode>::Type>(reference.object, x);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline auto tex1D(const raylab::simt::TextureReference<T, dimensions, mode>& reference, float x) {
    return tex1D<typename raylab::simt::Fetched<T, mode>::Type>(reference.object, x);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline auto tex2D(const raylab::simt::TextureReference<T, dimensions, mode>& reference, float x,
                  float y) {
    return tex2D<typename raylab::simt::Fetched<T, mode>::Type>(reference.object, x, y);
}
template <class T, int dimensions, cudaTextureReadMode mode>
inline auto tex3D(const raylab::simt::TextureReference<T, dimensions, mode>& reference, float x,
                  float y, float z) {
    return tex3D<typename raylab::simt::Fetched<T, mode>::Type>(reference.object, x, y, z);
}
