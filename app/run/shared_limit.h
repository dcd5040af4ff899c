// Static shared memory that no GPU has: nvcc refuses such a kernel, a compiler for the host does
// not.
#pragma once

#include <filesystem>
#include <string>

namespace raylab::app {

// Errors, a line each, "f.cu:7: error: ...", for the functions of an object file whose __shared__
// variables need more than 48 KiB together; empty if there are none or readelf is missing.
// `source`: what it was compiled from.
std::string too_much_shared(const std::filesystem::path& object, const std::string& source);

} // namespace raylab::app
