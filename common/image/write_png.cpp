// Writes PNG, for eyes, by stb.
#include "common/image/display.h"
#include "common/image/image_file.h"

#include <stb/stb_image_write.h>

namespace raylab {
namespace {

void append(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<char*>(data),
                                             static_cast<std::size_t>(size));
}

} // namespace

std::string encode_png(int width, int height, const std::vector<Rgb8>& pixels) {
    std::string bytes;
    stbi_write_png_to_func(append, &bytes, width, height, 3, pixels.data(), 3 * width);
    return bytes;
}

std::string encode_png(const Image& image, float exposure) {
    std::vector<Rgb8> pixels(image.pixels());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = display_rgb8(image.mean[i], exposure);
    return encode_png(image.width, image.height, pixels);
}

} // namespace raylab
