// The style and the script of class.html, which are files of their own.
#pragma once

namespace raylab {

extern const char* const class_page_css;
extern const char* const class_page_js;

} // namespace raylab
