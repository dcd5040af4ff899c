// The header of a Radiance picture. Internal to common/image.
#pragma once

#include "common/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raylab {

struct HdrHeader {
    bool is_xyz = false;        // CIE X, Y, Z instead of R, G, B
    DVec3 exposure = DVec3(1);  // what each channel was multiplied by
    bool columns_first = false; // a scanline is a column of the picture
    bool rightwards = true;     // x grows along a scanline or from one to the next
    bool downwards = true;      // so does y, counted from the top
    std::int64_t width = 0, height = 0;
    std::size_t end = 0; // where the pixels begin
};

// Throws DecodeError.
HdrHeader read_hdr_header(std::string_view bytes);

} // namespace raylab
