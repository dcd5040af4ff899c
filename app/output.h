// Images are checked before the work begins, as other outputs are (common/cli/files.h).
#pragma once

#include <string>

namespace raylab::app {

// prepare_output() for an image: throws UsageError if the name's ending is none that can be
// written, in capitals or not.
void prepare_image_output(const std::string& path);

} // namespace raylab::app
