// Whole files, read and written safely.
//
// A file appears under its name complete or not at all: the bytes go to a temporary name beside it,
// are flushed to the disk, and only then is the file renamed. A failure leaves what was there
// before.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace raylab {

// what() is a sentence for people: the path, what went wrong, what to do.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Writes `bytes` as the whole content of `path`, replacing what was there. A symbolic link is
// followed; a device or pipe (/dev/stdout) is written directly. Throws FileError.
void write_file(const std::string& path, std::string_view bytes);

// The whole content of `path`. Throws FileError.
std::string read_file(const std::string& path);

} // namespace raylab
