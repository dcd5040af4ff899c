// Image files. The name's ending chooses the format:
//
//   .exr  mean, its standard error and provenance, bit for bit: what the judge reads
//   .pfm  the mean alone, bit for bit
//   .hdr  the mean alone, 8 bits a channel and a shared exponent, for other programs
//   .png  for eyes: exposed, clamped, sRGB
#pragma once

#include "common/image/image.h"

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace raylab {

// what() is a sentence for people: the path, what was expected, what to do.
struct ImageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// No image file may be larger than this, so that a damaged header cannot ask for all memory.
constexpr int max_image_side = 32768;
constexpr std::size_t max_image_pixels = std::size_t(1) << 26;

// Reads .exr, .pfm, .hdr or .png. Non-finite values survive: it is for the judge to count them.
// Throws ImageError for a file that is missing, truncated, damaged, too large or without R, G, B.
Image read_image(const std::string& path);

// Writes by the ending of `path`, complete or not at all. `exposure` (in stops: the image is
// multiplied by 2^exposure) is for .png only. Throws ImageError if the
// image or the name is wrong, FileError (common/cli/files.h) if the file cannot be written.
void write_image(const Image& image, const std::string& path, float exposure = 0);

// The bytes of a PNG file, e.g. to embed in a report. Non-finite pixels are magenta.
std::string encode_png(const Image& image, float exposure = 0);

// The same for 8-bit R, G, B that are ready: width * height of them, top row first.
using Rgb8 = std::array<std::uint8_t, 3>;
std::string encode_png(int width, int height, const std::vector<Rgb8>& pixels);

} // namespace raylab
