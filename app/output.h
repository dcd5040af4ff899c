// Checks names of image files before the work begins, as common/cli/files.h does for other outputs.
#pragma once

#include <string>

namespace raylab::app {

// prepare_output() for an image file. Throws UsageError if raylab cannot write the format that the
// ending of the name stands for; capital letters make no difference.
void prepare_image_output(const std::string& path);

} // namespace raylab::app
