#include "app/output.h"

#include "app/labs.h"
#include "common/cli/files.h"

#include <fmt/format.h>

namespace raylab::app {

void prepare_image_output(const std::string& path) {
    const std::string ending = ending_of(path);
    if (ending != ".exr" && ending != ".pfm" && ending != ".hdr" && ending != ".png")
        throw UsageError(fmt::format("'{}' ends in '{}': images can be written as .exr (with "
                                     "variance), .pfm, .hdr or .png (for eyes)",
                                     path, ending));
    prepare_output(path);
}

} // namespace raylab::app
