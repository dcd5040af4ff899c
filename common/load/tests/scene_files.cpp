#include "common/load/tests/scene_files.h"

#include <cstdint>
#include <cstring>

namespace raylab {

std::string with(std::string scene, const std::string& from, const std::string& to) {
    const std::size_t at = scene.find(from);
    EXPECT_NE(at, scene.npos) << "the scene has no " << from;
    return at == scene.npos ? scene : scene.replace(at, from.size(), to);
}

std::string scene_of_shapes(const std::string& shapes) {
    const std::size_t begin = good_scene.find("    {\"kind\": \"sphere\""),
                      end = good_scene.find("\n  ],");
    return good_scene.substr(0, begin) + shapes + good_scene.substr(end);
}

Scene load(const std::string& text, const TemporaryFolder& folder) {
    return parse_scene(text, folder / "s.json");
}

Scene load(const std::string& text) { return parse_scene(text, "s.json"); }

std::string little_endian(std::initializer_list<float> values) {
    std::string bytes;
    for (const float value : values) {
        char raw[4];
        std::memcpy(raw, &value, 4);
        bytes.append(raw, 4);
    }
    return bytes;
}

namespace {

std::string big_endian(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

// CRC-32 as PNG wants it, bit by bit (PNG specification, annex D).
std::uint32_t crc(const std::string& bytes) {
    std::uint32_t c = 0xFFFFFFFF;
    for (const unsigned char byte : bytes) {
        c ^= byte;
        for (int bit = 0; bit < 8; ++bit) c = c & 1 ? 0xEDB88320 ^ c >> 1 : c >> 1;
    }
    return ~c;
}

std::string chunk(const std::string& type, const std::string& data) {
    return big_endian(std::uint32_t(data.size())) + type + data + big_endian(crc(type + data));
}

} // namespace

std::string png(int width, int height, const std::string& texels, int channels) {
    std::string rows;
    for (int y = 0; y < height; ++y)
        rows += '\0' + texels.substr(std::size_t(channels * width * y),
                                     std::size_t(channels * width)); // filter 0
    std::uint32_t a = 1, b = 0;                                      // Adler-32
    for (const unsigned char byte : rows) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = std::uint16_t(rows.size());
    const std::string stored = std::string("\x78\x01\x01", 3) + char(size & 255) + char(size >> 8) +
                               char(~size & 255) + char(~size >> 8 & 255) + rows +
                               big_endian(b << 16 | a);
    const std::string header = big_endian(std::uint32_t(width)) +
                               big_endian(std::uint32_t(height)) + std::string("\x08", 1) +
                               (channels == 4 ? '\x06' : '\x02') + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stored) + chunk("IEND", "");
}

std::string hdr(int width, int height, const std::string& rgbe) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
           std::to_string(width) + "\n" + rgbe;
}

} // namespace raylab
