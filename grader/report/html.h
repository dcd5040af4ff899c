// What is needed to write HTML: escaping (grader/results/text.h), pictures as data addresses, and a
// page around them.
#pragma once

#include "common/image/image.h"
#include "grader/results/text.h"

#include <string>
#include <string_view>

namespace raylab {

// JSON as it may stand inside <script>: no '<' can close the element.
std::string escape_script_json(std::string json);

// "data:image/png;base64,..." of an image in full range: twice as wide as the image, the left half
// holds 8-bit mantissas R, G, B, the right half their shared exponent e in all channels:
//     value = mantissa * 2^(e - 136), e = 255: not a number.
// Opaque, since browsers change colours under transparency. The page's script decodes it, so that
// exposure and pixel values work on radiance.
std::string radiance_png(const Image& image);

struct HtmlPage {
    std::string title, css, body;
    std::string data; // JSON, for the script to read from the element with the id "data"
    std::string script;
};

// A page of one file without any external address, light or dark as the reader's system is. Its
// security policy lets its own style and script run and nothing else: style attributes do not work.
std::string html_page(const HtmlPage& page);

} // namespace raylab
