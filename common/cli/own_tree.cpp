#include "common/cli/own_tree.h"

#include <fmt/format.h>

#include <stdexcept>

namespace raylab {

namespace fs = std::filesystem;

void expect_own_tree(const fs::path& built_as, const fs::path& root) {
    std::error_code unknown;
    const fs::path own = fs::read_symlink("/proc/self/exe", unknown);
    if (unknown) return;
    std::error_code missing;
    if (fs::equivalent(own, built_as, missing) && fs::is_directory(root)) return;
    throw std::runtime_error(fmt::format("{} was built for the tree {} and stands there no more: "
                                         "nothing was done; call the script ./raylab of the tree "
                                         "that you mean, which builds it anew",
                                         own.string(), root.string()));
}

} // namespace raylab
