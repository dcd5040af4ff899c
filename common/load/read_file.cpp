// Why a file cannot be read, in words.
#include "common/load/read_file.h"

#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace raylab {

std::string read_file(const std::filesystem::path& path, std::string& bytes) {
    const std::string name = path.string();
    if (name.find('\0') != name.npos) return "a file name must not contain a zero byte";
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) return fmt::format("there is no file {}", name);
    if (!std::filesystem::is_regular_file(status)) return fmt::format("{} is not a file", name);
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) return fmt::format("cannot read {}: {}", name, error.message());
    if (size > (std::uintmax_t(1) << 30))
        return fmt::format("{} is larger than 1 GiB; use a smaller file", name);
    std::ifstream file(path, std::ios::binary);
    bytes.resize(size);
    if (!file || !file.read(bytes.data(), std::streamsize(size)))
        return fmt::format("cannot read {}: {}", name, std::strerror(errno));
    return "";
}

std::string read_file_or_throw(const std::filesystem::path& path) {
    std::string bytes;
    if (const std::string problem = read_file(path, bytes); !problem.empty())
        throw SceneError(problem);
    return bytes;
}

} // namespace raylab
