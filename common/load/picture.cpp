// Which decoder reads a picture, and what a picture of a scene must be.
#include "common/load/picture.h"

#include "common/image/decode.h"
#include "common/image/display.h"
#include "common/load/jpeg.h"
#include "common/load/scene_error.h"

#include <fmt/format.h>

namespace raylab {
namespace {

constexpr PictureLimits limits{max_picture_side, max_picture_texels};

[[noreturn]] void fail(const std::string& name, const std::string& what) {
    throw SceneError(name + ": " + what);
}

Image decode_jpeg(std::string_view bytes) {
    const JpegHeader header = read_jpeg_header(bytes);
    check_picture_size(header.width, header.height, bytes.size(), limits);
    const std::vector<unsigned char> rgb = jpeg_texels(bytes, header);
    Image image;
    image.width = header.width;
    image.height = header.height;
    image.mean.resize(image.pixels());
    float linear[256];
    for (int value = 0; value < 256; ++value) linear[value] = linear_from_srgb(value / 255.0);
    for (std::size_t i = 0; i < image.pixels(); ++i)
        image.mean[i] = Vec3(linear[rgb[3 * i]], linear[rgb[3 * i + 1]], linear[rgb[3 * i + 2]]);
    return image;
}

void check_light(const Image& image, const std::string& name) {
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const Vec3 c = image.mean[i];
        if (!is_finite(c) || c.x < 0 || c.y < 0 || c.z < 0)
            fail(name, fmt::format("texel ({}, {}) is ({}, {}, {}); expected finite values of at "
                                   "least 0",
                                   int(i) % image.width, int(i) / image.width, c.x, c.y, c.z));
    }
}

} // namespace

Picture decode_picture(std::string_view bytes, const std::string& name) {
    Image image;
    std::vector<float> alpha;
    try {
        if (is_jpeg(bytes))
            image = decode_jpeg(bytes);
        else if (is_png(bytes))
            image = decode_png(bytes, limits, &alpha);
        else if (is_hdr(bytes))
            image = decode_hdr(bytes, limits);
        else
            fail(name, "expected a PNG, JPEG or Radiance HDR image, found something else");
    } catch (const DecodeError& error) {
        fail(name, fmt::format("cannot read the image: {}; write or copy it again", error.what()));
    }
    check_light(image, name);
    return {image.width, image.height, std::move(image.mean), std::move(alpha)};
}

} // namespace raylab
