// A whole file into memory.
#pragma once

#include <filesystem>
#include <string>

namespace raylab {

// Reads a regular file of at most 1 GiB. Returns what is wrong, naming the file, or "".
std::string read_file(const std::filesystem::path& path, std::string& bytes);

// The same. Throws SceneError with what is wrong.
std::string read_file_or_throw(const std::filesystem::path& path);

} // namespace raylab
