#include "grader/sandbox/work_folder.h"

#include "grader/sandbox/sandbox.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <system_error>
#include <unistd.h>

namespace raylab::sandbox {

namespace fs = std::filesystem;

WorkFolder::WorkFolder(const Isolation& isolation, std::uint64_t bytes, int files) {
    std::string name = (fs::temp_directory_path() / "raylab-work-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
    const std::string options = fmt::format("size={},nr_inodes={},mode=0700", bytes, files);
    mounted_ = isolation.mounts &&
               mount("raylab", name.c_str(), "tmpfs", MS_NOSUID | MS_NODEV, options.c_str()) == 0;
    give_to_sandbox(path_, isolation);
}

WorkFolder::~WorkFolder() {
    if (mounted_) umount2(path_.c_str(), MNT_DETACH);
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void give_to_sandbox(const fs::path& path, const Isolation& isolation) {
    if (!isolation.own_user) return;
    const uid_t user = sandbox_user();
    const auto give = [user](const fs::path& p) {
        if (lchown(p.c_str(), user, user) != 0)
            throw std::system_error(errno, std::generic_category(), p.string());
    };
    give(path);
    if (fs::is_directory(fs::symlink_status(path)))
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
            give(entry.path());
}

OutputFile read_output(const fs::path& folder, const std::string& name, std::uint64_t max_bytes) {
    const auto trouble = [&](const std::string& why) { return OutputFile{"", name + " " + why}; };
    const int directory = open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0) return trouble(fmt::format("was not read: {}", std::strerror(errno)));
    open_how how = {};
    how.flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
    int file = static_cast<int>(syscall(SYS_openat2, directory, name.c_str(), &how, sizeof how));
    // Kernels before 5.6: one name without a slash, not followed if it is a link.
    if (file < 0 && errno == ENOSYS && name.find('/') == name.npos)
        file = openat(directory, name.c_str(), static_cast<int>(how.flags));
    const int error = errno;
    close(directory);
    if (file < 0)
        return trouble(error == ENOENT  ? "was not written"
                       : error == ELOOP ? "is a symbolic link"
                                        : fmt::format("was not read: {}", std::strerror(error)));
    struct stat status {};
    fstat(file, &status);
    OutputFile out;
    if (!S_ISREG(status.st_mode))
        out = trouble("is no regular file");
    else if (status.st_nlink != 1)
        out = trouble("has a second name");
    else if (static_cast<std::uint64_t>(status.st_size) > max_bytes)
        out = trouble(fmt::format("has {} bytes, and {} are allowed", status.st_size, max_bytes));
    else {
        out.bytes.resize(static_cast<std::size_t>(status.st_size));
        std::size_t have = 0;
        for (ssize_t n; have < out.bytes.size() &&
                        (n = read(file, out.bytes.data() + have, out.bytes.size() - have)) > 0;)
            have += static_cast<std::size_t>(n);
        if (have != out.bytes.size()) out = trouble("changed while it was read");
    }
    close(file);
    return out;
}

} // namespace raylab::sandbox
