#include "common/cli/folder_lock.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace raylab {

FolderLock::FolderLock(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    handle_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle_ >= 0 && flock(handle_, LOCK_EX | LOCK_NB) == 0) return;
    const int error = errno;
    if (handle_ >= 0) close(handle_);
    handle_ = -1;
    if (error != EWOULDBLOCK)
        throw std::system_error(error, std::generic_category(), folder.string());
}

FolderLock::~FolderLock() {
    if (handle_ >= 0) close(handle_);
}

} // namespace raylab
