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

// An image of that size, all zero, after check_picture_size().
Image allocate(long long width, long long height, std::size_t bytes_in_file);

} // namespace raylab::formats
