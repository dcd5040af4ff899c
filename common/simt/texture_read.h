// Reading textures and surfaces, apart from the types of texels (api/texture_fetch.h).
//
// An Image lies in host memory, which no kernel may read. So only the engine reads it, whose loads
// the watch does not see: no function here that does is inline.
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
    int texel_bytes() const;
};
inline const Image& image_of(unsigned long long object) {
    return *reinterpret_cast<const Image*>(object);
}

// The texel's address, or null outside of the image.
char* texel(const Image& image, int x, int y, int z);

// The address in a surface, where x counts bytes; null outside, unless the place is clamped.
char* surface_texel(const Image& image, int x_bytes, int y, int z, bool clamped);

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
