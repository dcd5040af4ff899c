// A check that stb_image lacks.
#pragma once

#include <string_view>

namespace raylab {

// Does every Huffman table of a JPEG file have at most 256 codes? stb_image 2.27 writes beyond its
// table where one has more. True for what is no JPEG file.
bool huffman_tables_fit(std::string_view bytes);

} // namespace raylab
