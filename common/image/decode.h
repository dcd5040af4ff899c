// Pictures that other programs wrote, from the bytes of a whole file to linear RGB: what textures,
// environment maps and images to compare have in common. docs/formats.md says what is read.
#pragma once

#include "common/image/image.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

// A size beyond these is an error, before anything is allocated.
struct PictureLimits {
    int side = 0;
    std::int64_t pixels = 0;
};

// what() says what is wrong with "it", the picture, without its name and without a full stop.
struct DecodeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Which format the first bytes of a file show.
bool is_png(std::string_view bytes);
bool is_hdr(std::string_view bytes);

// PNG of every kind: 1 to 16 bits, grey, palette, interlaced. Values are sRGB whatever the file's
// colour chunks say; colours are not multiplied by alpha, which goes to `alpha` if it is wanted and
// anywhere below 1, pixel by pixel. Throws DecodeError, also for a wrong check sum.
Image decode_png(std::string_view bytes, PictureLimits limits, std::vector<float>* alpha = nullptr);

// Radiance HDR: RGBE or XYZE, packed in the old way, the new one or not at all, in any of the eight
// orientations; radiance as it was before EXPOSURE and COLORCORR. Throws DecodeError.
Image decode_hdr(std::string_view bytes, PictureLimits limits);

// Throws DecodeError for a size that no picture has, that is beyond the limits, or that so few
// bytes cannot hold: 10000 pixels a byte are beyond what PNG, JPEG and Radiance reach.
void check_picture_size(std::int64_t width, std::int64_t height, std::size_t bytes_in_file,
                        PictureLimits limits);

} // namespace raylab
