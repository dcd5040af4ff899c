// What a tree was when it was released, kept within it: an update needs to know what students have
// changed since.
#pragma once

#include <filesystem>

namespace raylab {

inline constexpr char released_as[] = ".released.tar.gz"; // in the root of the tree

// Packs the whole tree into its own archive; the same files give the same bytes. Needs tar. Throws
// std::runtime_error.
void pack_release(const std::filesystem::path& tree);

// Writes what the tree was into a new folder. Throws std::runtime_error.
void unpack_release(const std::filesystem::path& tree, const std::filesystem::path& folder);

} // namespace raylab
