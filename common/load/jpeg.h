// JPEG by libjpeg-turbo.
#pragma once

#include <string_view>
#include <vector>

namespace raylab {

struct JpegHeader {
    int width = 0, height = 0;
    bool is_cmyk = false; // printing inks: cyan, magenta, yellow, black (or YCCK, the same coded)
    bool is_inverted = false; // 255 is no ink, as Adobe's programs write it
};

// Does the file say that it is JPEG?
bool is_jpeg(std::string_view bytes);

// Throws DecodeError: damaged, cut off, or of a kind that is not read.
JpegHeader read_jpeg_header(std::string_view bytes);

// width x height x 3 bytes: sRGB, row by row, top row first. Throws DecodeError.
std::vector<unsigned char> jpeg_texels(std::string_view bytes, const JpegHeader& header);

} // namespace raylab
