// JPEG by libjpeg-turbo: stb_image 2.27 reads beyond its tables when a file's codes are broken.
#pragma once

#include <stdexcept>
#include <string_view>
#include <vector>

namespace raylab {

// A file that is broken or cut off; what() is libjpeg-turbo's reason.
struct JpegError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct PictureSize {
    int width = 0, height = 0;
};

// Does the file say that it is JPEG?
bool is_jpeg(std::string_view bytes);

// What the file's header says. Throws JpegError.
PictureSize jpeg_size(std::string_view bytes);

// width x height x 3 bytes: sRGB, row by row, top row first. Throws JpegError.
std::vector<unsigned char> jpeg_texels(std::string_view bytes, PictureSize size);

} // namespace raylab
