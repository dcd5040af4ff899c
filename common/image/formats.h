// The formats behind read_image and write_image, each from and to the bytes of a whole file.
// Internal to common/image: decoders throw std::runtime_error without naming the file.
#pragma once

#include "common/image/image_file.h"

namespace raylab::formats {

std::string encode_exr(const Image& image);
Image decode_exr(const std::string& bytes);

std::string encode_pfm(const Image& image);
Image decode_pfm(const std::string& bytes);

std::string encode_hdr(const Image& image);
Image decode_hdr(const std::string& bytes);
Image decode_png(const std::string& bytes);

// An image of that size, all zero. Throws when a header asks for too many pixels, or for more than
// `bytes_in_file` could hold at the best compression the formats reach (1 : 4096).
Image allocate(long long width, long long height, std::size_t bytes_in_file);

} // namespace raylab::formats
