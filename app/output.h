// Outputs are checked before the work begins: nobody should wait an hour to learn of a typing
// error.
#pragma once

#include <string>

namespace raylab::app {

// Makes the folder of `path` if need be and tries whether a file can be created there. Throws
// UsageError, which names the place and what to do.
void prepare_output(const std::string& path);

// The same for an image; throws also if the name's ending is none that can be written.
void prepare_image_output(const std::string& path);

} // namespace raylab::app
