// A check of image files that stb_image 2.27 lacks: without it a hostile file of a few bytes makes
// it ask for gigabytes.
#pragma once

#include <string_view>

namespace raylab {

// Does every chunk of a PNG file up to its last end within the file, and none of the image data
// have no bytes? True for what is no PNG file.
bool png_chunks_fit(std::string_view bytes);

} // namespace raylab
