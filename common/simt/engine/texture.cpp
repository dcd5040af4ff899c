// Texture objects; see api/texture.h and texture_read.h.
//
// The rules are those of the CUDA C++ Programming Guide, "Texture Fetching": linear filtering mixes
// the texels around (x - 0.5, y - 0.5, z - 0.5), with weights of 8 bits of fraction.
#include "common/simt/api/texture.h"

#include "common/simt/engine/machine.h"
#include "common/simt/engine/report.h"
#include "common/simt/small_float/format.h"
#include "common/simt/texture_read.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace raylab::simt {

namespace {

// What reads outside of the image become; -1: the border.
int addressed(int i, int size, cudaTextureAddressMode mode) {
    if (i >= 0 && i < size) return i;
    switch (mode) {
    case cudaAddressModeClamp:
        return i < 0 ? 0 : size - 1;
    case cudaAddressModeWrap:
        return (i % size + size) % size;
    case cudaAddressModeMirror:
        i = (i % (2 * size) + 2 * size) % (2 * size);
        return i < size ? i : 2 * size - 1 - i;
    default:
        return -1;
    }
}

// Wrap and mirror are for normalised coordinates alone; without those they are clamp.
cudaTextureAddressMode mode_of(const cudaTextureDesc& description, int axis) {
    auto mode = description.addressMode[axis];
    bool repeats = mode == cudaAddressModeWrap || mode == cudaAddressModeMirror;
    return repeats && !description.normalizedCoords ? cudaAddressModeClamp : mode;
}

// A coordinate in texels. Far outside it stays in the range of int.
float in_texels(const Image& image, int axis, float x) {
    float size = float(image.extent[axis]);
    if (image.description.normalizedCoords) {
        if (mode_of(image.description, axis) == cudaAddressModeWrap) x -= std::floor(x);
        if (mode_of(image.description, axis) == cudaAddressModeMirror) x -= 2 * std::floor(x / 2);
        x *= size;
    }
    return x == x ? std::clamp(x, -2.0f, 2 * size + 2) : 0;
}

const char* addressed_texel(const Image& image, int dimensions, const int (&at)[3], int layer) {
    int position[3] = {0, 0, 0};
    for (int axis = 0; axis < dimensions; ++axis) {
        position[axis] = addressed(at[axis], image.extent[axis], mode_of(image.description, axis));
        if (position[axis] < 0) return nullptr;
    }
    if (image.layered) position[2] = std::clamp(layer, 0, image.extent[2] - 1);
    return texel(image, position[0], position[1], position[2]);
}

Texel border(const Image& image) {
    Texel texel;
    std::memcpy(texel.channel, image.description.borderColor, sizeof texel.channel);
    return texel;
}

template <class T> T load(const char* address) {
    T value;
    std::memcpy(&value, address, sizeof value);
    return value;
}

float number(const char* address, int bits, cudaChannelFormatKind kind, bool normalised) {
    bool is_signed = kind == cudaChannelFormatKindSigned;
    if (kind == cudaChannelFormatKindFloat)
        return bits == 16 ? Format<5, 10>::to_float(load<uint16_t>(address)) : load<float>(address);
    float value = bits == 8    ? (is_signed ? load<int8_t>(address) : load<uint8_t>(address))
                  : bits == 16 ? (is_signed ? load<int16_t>(address) : load<uint16_t>(address))
                  : is_signed  ? float(load<int32_t>(address))
                               : float(load<uint32_t>(address));
    if (!normalised || bits == 32) return value;
    float largest = float((1u << (bits - is_signed)) - 1);
    return std::max(value / largest, -1.0f);
}

cudaError_t no_texture(const Where& where, const std::string& what) {
    return refuse(cudaErrorNotSupported, place(where) + ": error: " + what);
}

} // namespace

int Image::texel_bytes() const { return (channels.x + channels.y + channels.z + channels.w) / 8; }

char* texel(const Image& image, int x, int y, int z) {
    if (unsigned(x) >= unsigned(image.extent[0]) || unsigned(y) >= unsigned(image.extent[1]) ||
        unsigned(z) >= unsigned(image.extent[2]))
        return nullptr;
    return image.data + size_t(z) * image.layer + size_t(y) * image.row +
           size_t(x) * size_t(image.texel_bytes());
}

char* surface_texel(const Image& image, int x_bytes, int y, int z, bool clamped) {
    int x = x_bytes >= 0 ? x_bytes / image.texel_bytes() : -1;
    if (clamped) {
        x = std::clamp(x, 0, image.extent[0] - 1);
        y = std::clamp(y, 0, image.extent[1] - 1);
        z = std::clamp(z, 0, image.extent[2] - 1);
    }
    return texel(image, x, y, z);
}

Texel decode(const Image& image, const char* address) {
    Texel result{};
    const int bits[] = {image.channels.x, image.channels.y, image.channels.z, image.channels.w};
    bool normalised = image.description.readMode == cudaReadModeNormalizedFloat;
    for (int i = 0; i < 4 && bits[i]; address += bits[i] / 8, ++i)
        result.channel[i] = number(address, bits[i], image.channels.f, normalised);
    return result;
}

const char* nearest(const Image& image, int dimensions, float x, float y, float z, int layer) {
    const float point[] = {x, y, z};
    int at[3] = {0, 0, 0};
    for (int axis = 0; axis < dimensions; ++axis)
        at[axis] = int(std::floor(in_texels(image, axis, point[axis])));
    return addressed_texel(image, dimensions, at, layer);
}

Texel sample(const Image& image, int dimensions, float x, float y, float z, int layer) {
    if (image.description.filterMode == cudaFilterModePoint) {
        const char* address = nearest(image, dimensions, x, y, z, layer);
        return address ? decode(image, address) : border(image);
    }
    const float point[] = {x, y, z};
    int first[3] = {0, 0, 0};
    float weight[3] = {0, 0, 0};
    for (int axis = 0; axis < dimensions; ++axis) {
        // 1.8 fixed point: the fraction has 8 bits.
        float position = in_texels(image, axis, point[axis]) - 0.5f;
        float fixed = std::floor(position * 256 + 0.5f) / 256;
        first[axis] = int(std::floor(fixed));
        weight[axis] = fixed - float(first[axis]);
    }
    Texel sum{};
    for (int corner = 0; corner < 1 << dimensions; ++corner) {
        int at[3] = {first[0], first[1], first[2]};
        float share = 1;
        for (int axis = 0; axis < dimensions; ++axis) {
            bool second = corner >> axis & 1;
            at[axis] += second;
            share *= second ? weight[axis] : 1 - weight[axis];
        }
        if (share == 0) continue;
        const char* address = addressed_texel(image, dimensions, at, layer);
        Texel texel = address ? decode(image, address) : border(image);
        for (int i = 0; i < 4; ++i) sum.channel[i] += share * texel.channel[i];
    }
    return sum;
}

} // namespace raylab::simt

using namespace raylab::simt;

static cudaError_t make_image(unsigned long long* object, const cudaResourceDesc& resource,
                              const cudaTextureDesc& description, const Where& where) {
    auto image = new Image{};
    image->description = description;
    std::fill(image->extent, image->extent + 3, 1);
    if (resource.resType == cudaResourceTypeArray && resource.res.array.array) {
        const cudaArray& array = *resource.res.array.array;
        image->data = array.data;
        image->channels = array.channels;
        image->row = array.row_bytes();
        image->layered = array.flags & cudaArrayLayered;
        const size_t extent[] = {array.extent.width, array.extent.height, array.extent.depth};
        for (int axis = 0; axis < 3; ++axis) image->extent[axis] = std::max(int(extent[axis]), 1);
        image->layer = image->row * size_t(image->extent[1]);
    } else if (resource.resType == cudaResourceTypeLinear) {
        const auto& linear = resource.res.linear;
        image->data = static_cast<char*>(linear.devPtr);
        image->channels = linear.desc;
        image->extent[0] = int(linear.sizeInBytes / size_t(std::max(image->texel_bytes(), 1)));
    } else if (resource.resType == cudaResourceTypePitch2D) {
        const auto& pitch = resource.res.pitch2D;
        image->data = static_cast<char*>(pitch.devPtr);
        image->channels = pitch.desc;
        image->row = pitch.pitchInBytes;
        image->extent[0] = int(pitch.width);
        image->extent[1] = int(pitch.height);
    } else {
        delete image;
        return no_texture(where, "the CPU machine has no mipmapped textures");
    }
    *object = reinterpret_cast<unsigned long long>(image);
    return sticky_error();
}

cudaError_t cudaCreateTextureObject(cudaTextureObject_t* texture, const cudaResourceDesc* resource,
                                    const cudaTextureDesc* description, const cudaResourceViewDesc*,
                                    Where where) {
    if (description->sRGB) return no_texture(where, "the CPU machine has no sRGB textures");
    return make_image(texture, *resource, *description, where);
}

cudaError_t cudaCreateSurfaceObject(cudaSurfaceObject_t* surface, const cudaResourceDesc* resource,
                                    Where where) {
    return make_image(surface, *resource, {}, where);
}

cudaError_t cudaDestroyTextureObject(cudaTextureObject_t texture) {
    delete reinterpret_cast<Image*>(texture);
    return sticky_error();
}

cudaError_t cudaDestroySurfaceObject(cudaSurfaceObject_t surface) {
    return cudaDestroyTextureObject(surface);
}
