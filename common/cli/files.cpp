// Safe writing by write, fsync, rename: the POSIX recipe for replacing a file atomically.
#include "common/cli/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace raylab {
namespace fs = std::filesystem;
namespace {

// What to tell people about an errno.
std::string explain(int error, const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return "the disk is full: free some space, or write to another folder";
    case EFBIG:
        return "the file would be larger than is allowed here (see `ulimit -f`)";
    case EACCES:
    case EPERM:
        return fmt::format("no permission: check the rights of the file and of the folder '{}', "
                           "or name another one",
                           folder.string());
    case EROFS:
        return fmt::format("the folder '{}' is on a read-only disk: name another folder",
                           folder.string());
    case ENOENT:
        return fs::exists(folder) ? "there is no such file: check the name"
                                  : fmt::format("there is no folder '{}': create it, or check the "
                                                "name",
                                                folder.string());
    case ENOTDIR:
        return fmt::format("'{}' is not a folder: check the name", folder.string());
    case EISDIR:
        return "it is a folder, and a file was expected: add a file name";
    case ENAMETOOLONG:
        return "the name is too long: choose a shorter one";
    default:
        return std::strerror(error);
    }
}

[[noreturn]] void fail(const char* doing, const fs::path& path, int error) {
    throw FileError(fmt::format("cannot {} '{}': {}", doing, path.string(), explain(error, path)));
}

// An open file that closes itself; close() reports what the disk says at the very end.
class Descriptor {
  public:
    Descriptor(const fs::path& path, int flags)
        : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool is_open() const { return fd_ >= 0; }
    int get() const { return fd_; }
    bool close() { return fd_ < 0 || ::close(std::exchange(fd_, -1)) == 0; }

  private:
    int fd_;
};

// 0, or the errno of the first write that failed.
int write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(fd, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

void write_directly(const fs::path& path, std::string_view bytes) {
    Descriptor file(path, O_WRONLY);
    if (!file.is_open()) fail("write", path, errno);
    if (const int error = write_all(file.get(), bytes)) fail("write", path, error);
    if (!file.close()) fail("write", path, errno);
}

} // namespace

void write_file(const std::string& name, std::string_view bytes) {
    std::error_code ignored;
    fs::path path(name);
    if (name.empty()) throw FileError("cannot write a file without a name: give one");
    if (const fs::path real = fs::weakly_canonical(path, ignored);
        fs::is_symlink(path, ignored) && !real.empty())
        path = real;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status) || !path.has_filename()) fail("write", path, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) return write_directly(path, bytes);

    // O_EXCL: never write into a file that someone else made.
    fs::path temporary;
    int attempt = 0;
    do {
        temporary = path;
        temporary.replace_filename(
            fmt::format(".{}.{}-{}.part", path.filename().string(), ::getpid(), attempt++));
        Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL);
        if (!file.is_open() && errno == EEXIST) continue;
        if (!file.is_open()) fail("write", path, errno);
        int error = write_all(file.get(), bytes);
        if (!error && ::fsync(file.get()) != 0) error = errno;
        if (!file.close() && !error) error = errno;
        if (!error && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
        if (!error) return;
        ::unlink(temporary.c_str());
        fail("write", path, error);
    } while (attempt < 100);
    fail("write", path, EEXIST);
}

std::string read_file(const std::string& name) {
    Descriptor file(name, O_RDONLY);
    if (!file.is_open()) fail("read", name, errno);
    std::string bytes;
    char block[1 << 16];
    for (;;) {
        const ssize_t n = ::read(file.get(), block, sizeof block);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail("read", name, errno);
        if (n == 0) return bytes;
        bytes.append(block, static_cast<std::size_t>(n));
    }
}

} // namespace raylab
