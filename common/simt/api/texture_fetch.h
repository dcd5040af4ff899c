// Reading texture objects and surface objects in kernels.
#pragma once

#include "common/simt/collectives.h"
#include "common/simt/texture_read.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

// What a surface gives for places outside of it, and what becomes of writes there.
enum cudaSurfaceBoundaryMode {
    cudaBoundaryModeZero = 0,
    cudaBoundaryModeClamp = 1,
    cudaBoundaryModeTrap = 2,
};

namespace raylab::simt {

// The caller's type of four floats.
template <class T> inline T from_floats(const Texel& texel) {
    using Element = typename Channels<T>::Element;
    Element elements[4];
    for (int i = 0; i < 4; ++i) elements[i] = Element(texel.channel[i]);
    T value;
    std::memcpy(&value, elements, sizeof(T));
    return value;
}

// A texel of integers comes as it is; one of floats may be a mixture.
template <class T>
inline T fetch(cudaTextureObject_t object, int dimensions, float x, float y, float z,
               int layer = 0) {
    const Image& image = image_of(object);
    if constexpr (std::is_floating_point_v<typename Channels<T>::Element>) {
        return from_floats<T>(sample(image, dimensions, x, y, z, layer));
    } else {
        T value{};
        if (const char* address = nearest(image, dimensions, x, y, z, layer))
            std::memcpy(&value, address, std::min(sizeof(T), size_t(image.texel_bytes())));
        return value;
    }
}

// The bytes of a surface's texel; x counts bytes.
inline char* surface_texel(cudaSurfaceObject_t object, int x_bytes, int y, int z,
                           cudaSurfaceBoundaryMode mode) {
    char* address = surface_texel(image_of(object), x_bytes, y, z, mode == cudaBoundaryModeClamp);
    if (!address && mode == cudaBoundaryModeTrap)
        trap(RAYLAB_SITE("an access outside of a surface"));
    return address;
}
template <class T>
inline T surface_read(cudaSurfaceObject_t object, int x, int y, int z,
                      cudaSurfaceBoundaryMode mode) {
    T value{};
    if (const char* address = surface_texel(object, x, y, z, mode))
        std::memcpy(&value, address, sizeof value);
    return value;
}
template <class T>
inline void surface_write(const T& value, cudaSurfaceObject_t object, int x, int y, int z,
                          cudaSurfaceBoundaryMode mode) {
    if (char* address = surface_texel(object, x, y, z, mode))
        std::memcpy(address, &value, sizeof value);
}

} // namespace raylab::simt

template <class T> inline T tex1Dfetch(cudaTextureObject_t texture, int x) {
    const raylab::simt::Image& image = raylab::simt::image_of(texture);
    const char* address = raylab::simt::texel(image, x, 0, 0);
    if (!address) return T{};
    if constexpr (std::is_floating_point_v<typename raylab::simt::Channels<T>::Element>) {
        (void)*static_cast<const volatile char*>(address); // for who looks at the kernel's accesses
        return raylab::simt::from_floats<T>(raylab::simt::decode(image, address));
    }
    T value{};
    std::memcpy(&value, address, std::min(sizeof(T), size_t(image.texel_bytes())));
    return value;
}
template <class T> inline T tex1D(cudaTextureObject_t texture, float x) {
    return raylab::simt::fetch<T>(texture, 1, x, 0, 0);
}
template <class T> inline T tex2D(cudaTextureObject_t texture, float x, float y) {
    return raylab::simt::fetch<T>(texture, 2, x, y, 0);
}
template <class T> inline T tex3D(cudaTextureObject_t texture, float x, float y, float z) {
    return raylab::simt::fetch<T>(texture, 3, x, y, z);
}
template <class T> inline T tex1DLayered(cudaTextureObject_t texture, float x, int layer) {
    return raylab::simt::fetch<T>(texture, 1, x, 0, 0, layer);
}
template <class T> inline T tex2DLayered(cudaTextureObject_t texture, float x, float y, int layer) {
    return raylab::simt::fetch<T>(texture, 2, x, y, 0, layer);
}
// The level of detail of a texture without mipmaps is 0.
template <class T> inline T tex2DLod(cudaTextureObject_t texture, float x, float y, float) {
    return tex2D<T>(texture, x, y);
}
// With the result as first argument.
template <class T> inline void tex1Dfetch(T* value, cudaTextureObject_t texture, int x) {
    *value = tex1Dfetch<T>(texture, x);
}
template <class T> inline void tex2D(T* value, cudaTextureObject_t texture, float x, float y) {
    *value = tex2D<T>(texture, x, y);
}

#define RAYLAB_MODE cudaSurfaceBoundaryMode mode = cudaBoundaryModeTrap

template <class T> inline T surf1Dread(cudaSurfaceObject_t surface, int x, RAYLAB_MODE) {
    return raylab::simt::surface_read<T>(surface, x, 0, 0, mode);
}
template <class T> inline T surf2Dread(cudaSurfaceObject_t surface, int x, int y, RAYLAB_MODE) {
    return raylab::simt::surface_read<T>(surface, x, y, 0, mode);
}
template <class T>
inline T surf3Dread(cudaSurfaceObject_t surface, int x, int y, int z, RAYLAB_MODE) {
    return raylab::simt::surface_read<T>(surface, x, y, z, mode);
}
template <class T>
inline void surf1Dread(T* value, cudaSurfaceObject_t surface, int x, RAYLAB_MODE) {
    *value = raylab::simt::surface_read<T>(surface, x, 0, 0, mode);
}
template <class T>
inline void surf2Dread(T* value, cudaSurfaceObject_t surface, int x, int y, RAYLAB_MODE) {
    *value = raylab::simt::surface_read<T>(surface, x, y, 0, mode);
}
template <class T>
inline void surf1Dwrite(T value, cudaSurfaceObject_t surface, int x, RAYLAB_MODE) {
    raylab::simt::surface_write(value, surface, x, 0, 0, mode);
}
template <class T>
inline void surf2Dwrite(T value, cudaSurfaceObject_t surface, int x, int y, RAYLAB_MODE) {
    raylab::simt::surface_write(value, surface, x, y, 0, mode);
}
template <class T>
inline void surf3Dwrite(T value, cudaSurfaceObject_t surface, int x, int y, int z, RAYLAB_MODE) {
    raylab::simt::surface_write(value, surface, x, y, z, mode);
}

#undef RAYLAB_MODE
