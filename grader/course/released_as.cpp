#include "grader/course/released_as.h"

#include "common/cli/process.h"

#include <fmt/format.h>

#include <stdexcept>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr double tar_limit_seconds = 300;

void run_tar(std::vector<std::string> words, const fs::path& archive) {
    words.insert(words.begin(), "tar");
    const ProcessResult result = run_process(words, {.limit_seconds = tar_limit_seconds});
    if (!result.succeeded())
        throw std::runtime_error(fmt::format("'{}': tar {}", archive.string(), why_failed(result)));
}

} // namespace

void pack_release(const fs::path& tree) {
    // Beside the tree first: within it the archive would change the folder that tar reads.
    const fs::path archive = fs::absolute(tree).string() + ".tar.gz";
    // gzip -n writes neither name nor time.
    run_tar({"-C", tree.string(), "--sort=name", "--mtime=@0", "--owner=0", "--group=0",
             "--numeric-owner", "-I", "gzip -n", "-cf", archive.string(), "."},
            archive);
    fs::rename(archive, tree / released_as);
}

void unpack_release(const fs::path& tree, const fs::path& folder) {
    const fs::path archive = fs::absolute(tree / released_as);
    fs::create_directories(folder);
    run_tar({"-C", folder.string(), "-xzf", archive.string()}, archive);
}

} // namespace raylab
