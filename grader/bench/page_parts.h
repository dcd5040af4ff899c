// page.css, plot_parts.js and page.js as text, put into the program by the build
// (page_parts.cpp.in).
#pragma once

namespace raylab::bench {

extern const char* const page_css; // what grader/report's style lacks
extern const char* const plot_parts_js;
extern const char* const page_js;

} // namespace raylab::bench
