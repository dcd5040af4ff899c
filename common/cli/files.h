// Whole files, read and written safely.
//
// A file appears under its name complete or not at all: the bytes go to a temporary name beside it,
// are flushed to the disk, and only then is the file renamed. A failure leaves what was there
// before, and so does a signal that ends the program.
#pragma once

#include "common/cli/exit_codes.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace raylab {

// what() is a sentence for people: the path, what went wrong, what to do.
struct FileError : std::runtime_error {
    FileError(const std::string& what, ExitCode status) : std::runtime_error(what), code(status) {}

    // bad_usage: another name would do. tool_failed: the machine is in trouble, such as a full
    // disk.
    ExitCode code;
};

// Turns an exception of std::filesystem into a FileError. Only the program's outermost handler
// calls it, since not every call of std::filesystem can be asked for an error code instead.
FileError file_error(const std::filesystem::filesystem_error& error);

// Writes `bytes` as the whole content of `path`, replacing what was there. A symbolic link is
// followed; a device or pipe (/dev/stdout) is written directly. Throws FileError.
void write_file(const std::string& path, std::string_view bytes);

// For an output that is to be written after long work: makes its folder if need be and tries
// whether a file can be made there under that name, so that nobody waits an hour to learn of a
// typing error. Throws FileError.
void prepare_output(const std::string& path);

// The whole content of `path`. Throws FileError.
std::string read_file(const std::string& path);

// How a name ends, in lower case: ".png" of "a/X.PNG". Files are told apart by this alone, however
// a camera or an old system has spelt it.
std::string ending_of(const std::filesystem::path& path);

} // namespace raylab
