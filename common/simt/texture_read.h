// Reading textures and surfaces, apart from the types of texels (api/texture_fetch.h).
#pragma once

#include "common/simt/api/texture.h"

namespace raylab::simt {

// What an object stands for; a texture or surface object is its address.
struct Image {
    char* data;
    size_t row, layer; // bytes to the next row, and layer
    int extent[3];     // in texels; 1 in the directions that there are not
    cudaChannelFormatDesc channels;
    cudaTextureDesc description;
    bool layered;
    int texel_bytes() const { return (channels.x + channels.y + channels.z + channels.w) / 8; }
};
inline const Image& image_of(unsigned long long object) {
    return *reinterpret_cast<const Image*>(object);
}

// The texel's address, or null outside of the image.
inline char* texel(const Image& image, int x, int y, int z) {
    if (unsigned(x) >= unsigned(image.extent[0]) || unsigned(y) >= unsigned(image.extent[1]) ||
        unsigned(z) >= unsigned(image.extent[2]))
        return nullptr;
    return image.data + size_t(z) * image.layer + size_t(y) * image.row +
           size_t(x) * size_t(image.texel_bytes());
}

// The texel that holds a point, or a mixture of those around it, as floats. Coordinates that the
// texture lacks are 0; `layer` chooses one of a layered array.
struct Texel {
    float channel[4];
};
Texel sample(const Image& image, int dimensions, float x, float y, float z, int layer);

// The address of the texel that a point texture of integers gives; null: the border's 0.
const char* nearest(const Image& image, int dimensions, float x, float y, float z, int layer);

// A texel's numbers as floats, normalised if the texture says so.
Texel decode(const Image& image, const char* address);

} // namespace raylab::simt
