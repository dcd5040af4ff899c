// PFM: "PF\n<width> <height>\n-1.0\n", then rows of 32-bit floats, bottom row first. A negative
// scale means little endian (Debevec's format; its magnitude is a unit that no program agrees on).
#include "common/cli/parse_double.h"
#include "common/image/formats.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstring>

namespace raylab::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "PFM rows are copied as they lie");

std::uint32_t swap_bytes(std::uint32_t v) {
    return v >> 24 | (v >> 8 & 0xff00) | (v << 8 & 0xff0000) | v << 24;
}

// The next word of the header; `at` moves past it and the one separator behind it.
std::string_view next_word(const std::string& bytes, std::size_t& at) {
    const std::size_t end = bytes.find_first_of(" \t\r\n", at);
    if (end == std::string::npos || end - at > 32)
        throw std::runtime_error("it does not start with a PFM header "
                                 "('PF', width, height, scale)");
    const std::string_view word(bytes.data() + at, end - at);
    at = end + 1;
    if (bytes[end] == '\r' && at < bytes.size() && bytes[at] == '\n') ++at;
    return word;
}

std::from_chars_result parse(const char* begin, const char* end, double& value) {
    return parse_double(begin, end, value);
}
std::from_chars_result parse(const char* begin, const char* end, long long& value) {
    return std::from_chars(begin, end, value);
}

template <class Number> Number parse(std::string_view word, const char* name) {
    Number value{};
    const auto [end, error] = parse(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        throw std::runtime_error(fmt::format("its {} '{}' is not a number", name, word));
    return value;
}

} // namespace

std::string encode_pfm(const Image& image) {
    std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    const std::size_t row = sizeof(Vec3) * static_cast<std::size_t>(image.width);
    for (int y = image.height - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char*>(&image.at(0, y)), row);
    return bytes;
}

Image decode_pfm(const std::string& bytes) {
    std::size_t at = 0;
    const std::string_view magic = next_word(bytes, at);
    const int channels = magic == "PF" ? 3 : magic == "Pf" ? 1 : 0;
    if (channels == 0)
        throw std::runtime_error("it does not start with 'PF' (colour) or 'Pf' (grey)");
    const auto width = parse<long long>(next_word(bytes, at), "width");
    const auto height = parse<long long>(next_word(bytes, at), "height");
    const auto scale = parse<double>(next_word(bytes, at), "scale");

    const std::size_t have = bytes.size() - at;
    Image image = allocate(width, height, have);
    const std::size_t need = image.pixels() * static_cast<std::size_t>(channels) * sizeof(float);
    if (have != need)
        throw std::runtime_error(
            fmt::format("{} x {} pixels need {} bytes and it has {}", width, height, need, have));

    const char* in = bytes.data() + at;
    for (int y = image.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.width; ++x) {
            Vec3& pixel = image.mean[static_cast<std::size_t>(y) * image.width + x];
            for (int c = 0; c < channels; ++c, in += sizeof(float)) {
                std::uint32_t bits;
                std::memcpy(&bits, in, sizeof bits);
                if (scale > 0) bits = swap_bytes(bits);
                std::memcpy(&pixel[c], &bits, sizeof bits);
            }
            if (channels == 1) pixel = Vec3(pixel.x);
        }
    }
    return image;
}

} // namespace raylab::formats
