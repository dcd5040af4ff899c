// PNG and Radiance by stb_image, which goes on behind the end of a file as if there were zeros, in
// Radiance files for ever: so we hand it the bytes through callbacks, and notice when it asks for
// too many. JPEG is in jpeg.cpp.
#include "common/scene/picture.h"

#include "common/scene/image_checks.h"
#include "common/scene/jpeg.h"
#include "common/scene/scene_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#define STBI_ONLY_PNG
#define STBI_ONLY_HDR
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace raylab {
namespace {

struct ByteReader {
    std::string_view bytes;
    std::size_t at = 0;
    bool past_end = false;

    // Behind the end come line feeds, on which every decoder ends: as a Radiance header they are
    // its last line, as a run they are too long for what is left, as a PNG chunk they are unknown.
    static int read(void* user, char* data, int size) {
        ByteReader& self = *static_cast<ByteReader*>(user);
        const std::size_t count = std::min(std::size_t(size), self.bytes.size() - self.at);
        std::memcpy(data, self.bytes.data() + self.at, count);
        self.at += count;
        if (count > 0) return int(count);
        self.past_end = true;
        std::memset(data, '\n', std::size_t(size));
        return size;
    }
    static void skip(void* user, int count) {
        ByteReader& self = *static_cast<ByteReader*>(user);
        const std::size_t left = self.bytes.size() - self.at;
        if (count > 0 && std::size_t(count) > left) self.past_end = true;
        self.at = count < 0 ? self.at - std::min(self.at, std::size_t(-std::int64_t(count)))
                            : self.at + std::min(left, std::size_t(count));
    }
    static int eof(void* user) {
        const ByteReader& self = *static_cast<ByteReader*>(user);
        return self.at == self.bytes.size();
    }
};

constexpr stbi_io_callbacks callbacks{ByteReader::read, ByteReader::skip, ByteReader::eof};

constexpr const char* too_short =
    "the image ends too early: the file was cut off; write or copy it again";

[[noreturn]] void fail(const std::string& name, const std::string& what) {
    throw SceneError(name + ": " + what);
}

[[noreturn]] void fail_as_broken(const std::string& name, const char* reason) {
    fail(name, fmt::format("the image is broken ({}); write it again", reason));
}

// `texels_per_byte` is beyond what the format's compression can do: a file of a few bytes must not
// make us allocate a large image.
void check_size(PictureSize size, std::size_t bytes, std::size_t texels_per_byte,
                const std::string& name) {
    if (size.width < 1 || size.height < 1 || size.width > max_picture_side ||
        size.height > max_picture_side || size.width > max_picture_texels / size.height)
        fail(name, fmt::format("expected an image of 1 to {} texels a side and at most {} in all, "
                               "found {} x {}",
                               max_picture_side, max_picture_texels, size.width, size.height));
    if (bytes < std::size_t(size.width) * std::size_t(size.height) / texels_per_byte)
        fail(name, too_short);
}

Picture picture_from_srgb(PictureSize size, const unsigned char* rgb) {
    float linear[256];
    for (int value = 0; value < 256; ++value) linear[value] = linear_from_srgb(value);
    Picture picture{size.width, size.height,
                    std::vector<Vec3>(std::size_t(size.width) * std::size_t(size.height))};
    for (Vec3& texel : picture.texels) {
        texel = Vec3(linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]);
        rgb += 3;
    }
    return picture;
}

Picture picture_from_radiance(PictureSize size, const float* rgb, const std::string& name) {
    Picture picture{size.width, size.height,
                    std::vector<Vec3>(std::size_t(size.width) * std::size_t(size.height))};
    std::memcpy(picture.texels.data(), rgb, picture.texels.size() * sizeof(Vec3));
    for (std::size_t i = 0; i < picture.texels.size(); ++i) {
        const Vec3 c = picture.texels[i];
        if (!is_finite(c) || c.x < 0 || c.y < 0 || c.z < 0)
            fail(name, fmt::format("texel ({}, {}) is ({}, {}, {}); expected finite values of at "
                                   "least 0",
                                   int(i) % size.width, int(i) / size.width, c.x, c.y, c.z));
    }
    return picture;
}

Picture decode_jpeg(std::string_view bytes, const std::string& name) {
    try {
        const PictureSize size = jpeg_size(bytes);
        check_size(size, bytes.size(), 10000, name);
        return picture_from_srgb(size, jpeg_texels(bytes, size).data());
    } catch (const JpegError& error) {
        fail_as_broken(name, error.what());
    }
}

} // namespace

float linear_from_srgb(int value) {
    const double s = value / 255.0;
    return float(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

Picture decode_picture(std::string_view bytes, const std::string& name) {
    if (is_jpeg(bytes)) return decode_jpeg(bytes, name);
    if (!png_chunks_fit(bytes)) fail(name, too_short);
    PictureSize size;
    int channels = 0;
    ByteReader reader{bytes};
    if (!stbi_info_from_callbacks(&callbacks, &reader, &size.width, &size.height, &channels))
        fail(name, reader.past_end && !bytes.empty()
                       ? too_short
                       : "expected a PNG, JPEG or Radiance HDR image, found something else");

    ByteReader probe{bytes};
    const bool is_hdr = stbi_is_hdr_from_callbacks(&callbacks, &probe);
    // Four runs of at most 127 equal bytes each are the best that Radiance's compression can do;
    // PNG's is less than 10000 texels a byte.
    check_size(size, bytes.size(), is_hdr ? 16 : 10000, name);
    reader = ByteReader{bytes};
    const std::unique_ptr<void, decltype(&stbi_image_free)> pixels(
        is_hdr ? static_cast<void*>(stbi_loadf_from_callbacks(&callbacks, &reader, &size.width,
                                                              &size.height, &channels, 3))
               : stbi_load_from_callbacks(&callbacks, &reader, &size.width, &size.height, &channels,
                                          3),
        stbi_image_free);
    if (reader.past_end) fail(name, too_short);
    if (!pixels) fail_as_broken(name, stbi_failure_reason());
    return is_hdr ? picture_from_radiance(size, static_cast<const float*>(pixels.get()), name)
                  : picture_from_srgb(size, static_cast<const unsigned char*>(pixels.get()));
}

} // namespace raylab
