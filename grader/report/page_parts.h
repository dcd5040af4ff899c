// page.css and page.js as text, put into the program by the build (page_parts.cpp.in).
#pragma once

namespace raylab {

extern const char* const page_css;
extern const char* const page_js;

} // namespace raylab
