// Where libarchive is missing: folders are read, archives are refused.
#include "grader/submissions/archive.h"
#include "grader/submissions/submission_error.h"

#include <fmt/format.h>

namespace raylab {

namespace {

[[noreturn]] void refuse(const std::string& name) {
    throw SubmissionError(fmt::format("the archive '{}' is not read: this raylab was built without "
                                      "libarchive; unpack it and name the folder, or install "
                                      "libarchive-dev and build again",
                                      name));
}

} // namespace

void read_archive(const std::filesystem::path&, const std::string& name, const UnpackLimits&,
                  const TakeEntry&) {
    refuse(name);
}

void read_archive_bytes(std::string_view, const std::string& name, const UnpackLimits&,
                        const TakeEntry&) {
    refuse(name);
}

} // namespace raylab
