// The package of a platform: what it needs to grade submissions of one lab, ready to upload.
#pragma once

#include "app/grade/autograder/platform.h"
#include "grader/course/lab_sheet.h"

#include <filesystem>

namespace raylab::app {

// Writes the package into `folder`, which must not be there or be empty: another key in a package
// that is in use would change the hidden scenes. It appears there complete or not at all, and only
// its owner can read it. Throws FileError, or std::runtime_error if the tree cannot be packed.
void write_package(const Platform& platform, const LabSheet& sheet,
                   const std::filesystem::path& folder);

} // namespace raylab::app
