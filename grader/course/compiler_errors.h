// What the compiler says of a lab, out of all that a build prints.
#pragma once

#include <filesystem>
#include <string>

namespace raylab {

// The compiler's messages, without Ninja's lines and the command lines, at most 40 lines; file
// names are relative to the root.
std::string compiler_errors(const std::string& output, const std::filesystem::path& root);

} // namespace raylab
