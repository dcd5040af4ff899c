// Whether a program still stands where it was built, for the tree that it was built from.
#pragma once

#include <filesystem>

namespace raylab {

// Throws std::runtime_error, one sentence, unless this very program is the file `built_as` (by
// identity, not by name): a program that was copied or moved, alone or with its build folder, still
// knows `root`, and would judge what lies there instead of the tree around it. Nothing is said
// where /proc does not tell which file this program is.
void expect_own_tree(const std::filesystem::path& built_as, const std::filesystem::path& root);

} // namespace raylab
