// PNG, for eyes, by stb.
#include "common/image/display.h"
#include "common/image/formats.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <fmt/format.h>

#include <climits>
#include <memory>

namespace raylab {
namespace {

void append(void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<char*>(data),
                                             static_cast<std::size_t>(size));
}

using Pixels = std::unique_ptr<void, decltype(&stbi_image_free)>;

// The size in the header is checked before stb allocates anything.
Image sized_by_header(const std::string& bytes) {
    int width = 0, height = 0, channels = 0;
    if (bytes.size() > INT_MAX) throw std::runtime_error("it is larger than 2 GiB");
    if (!stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                               static_cast<int>(bytes.size()), &width, &height, &channels))
        throw std::runtime_error(fmt::format("its header is damaged ({})", stbi_failure_reason()));
    return formats::allocate(width, height, bytes.size());
}

[[noreturn]] void damaged() {
    throw std::runtime_error(fmt::format("it is truncated or damaged ({})", stbi_failure_reason()));
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

Image formats::decode_png(const std::string& bytes) {
    Image image = sized_by_header(bytes);
    int w = 0, h = 0, n = 0;
    const Pixels pixels(stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                              static_cast<int>(bytes.size()), &w, &h, &n, 3),
                        stbi_image_free);
    if (!pixels) damaged();
    const auto* rgb = static_cast<const stbi_uc*>(pixels.get());
    for (std::size_t i = 0; i < image.pixels(); ++i)
        for (int c = 0; c < 3; ++c)
            image.mean[i][c] = linear_from_srgb(rgb[3 * i + static_cast<std::size_t>(c)] / 255.0f);
    return image;
}

} // namespace raylab
