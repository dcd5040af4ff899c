// Whether a program still stands where it was built, for the tree that it was built from.
#pragma once

#include <filesystem>

namespace raylab {

// Throws std::runtime_error, one sentence, unless this program is the file `built_as`; files are
// compared by identity, not by name. A program that was copied or moved, alone or with its build
// folder, still has `root` compiled in, and would judge the tree there instead of the tree around
// it. Does nothing if /proc does not say which file this program is.
void expect_own_tree(const std::filesystem::path& built_as, const std::filesystem::path& root);

} // namespace raylab
