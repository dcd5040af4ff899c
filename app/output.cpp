#include "app/output.h"

#include "app/labs.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace raylab::app {

namespace fs = std::filesystem;

void prepare_output(const std::string& path) {
    if (path == "/dev/stdout" || path == "/dev/null") return;
    if (fs::is_directory(path))
        throw UsageError(fmt::format("'{}' is a folder: name a file", path));
    const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : ".";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw UsageError(
            fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
    std::string probe = (folder / ".raylab-probe-XXXXXX").string();
    const int file = mkstemp(probe.data());
    if (file < 0)
        throw UsageError(fmt::format("cannot write to '{}': {}; choose another place with -o",
                                     folder.string(), std::strerror(errno)));
    close(file);
    unlink(probe.c_str());
}

void prepare_image_output(const std::string& path) {
    const std::string ending = fs::path(path).extension().string();
    if (ending != ".exr" && ending != ".pfm" && ending != ".hdr" && ending != ".png")
        throw UsageError(fmt::format("'{}' ends in '{}': images can be written as .exr (with "
                                     "variance), .pfm, .hdr or .png (for eyes)",
                                     path, ending));
    prepare_output(path);
}

} // namespace raylab::app
