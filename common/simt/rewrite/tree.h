// A program of several files, rewritten as a whole: the source and the headers of its own.
#pragma once

#include <filesystem>
#include <vector>

namespace raylab::simt {

// Writes a copy of `source`, fit for a host compiler, to the folder `out`, and of every header that
// it includes and that lies beside it, below, or in one of `folders`; copies include copies. #line
// names the originals. A folder with thrust is only noted. Returns the copy of `source`. Throws
// RewriteError, and std::runtime_error for a file that cannot be read or written.
std::filesystem::path rewrite_tree(const std::filesystem::path& source,
                                   const std::filesystem::path& out,
                                   const std::vector<std::filesystem::path>& folders);

} // namespace raylab::simt
