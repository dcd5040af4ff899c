// Safe writing by write, fsync, rename: the POSIX recipe for replacing a file atomically.
#include "common/cli/files.h"

#include "common/cli/leftovers.h"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace raylab {
namespace fs = std::filesystem;
namespace {

// What to tell people about an errno. `makes_file`: a file was to be made, not found.
std::string explain(int error, const fs::path& path, bool makes_file) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code ignored;
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
        if (!fs::exists(folder, ignored))
            return fmt::format("there is no folder '{}': create it, or check the name",
                               folder.string());
        return makes_file ? fmt::format("the folder '{}' takes no new files: name another folder",
                                        folder.string())
                          : "there is no such file: check the name";
    case ENOTDIR:
        return fmt::format("'{}' is not a folder: check the name", folder.string());
    case EISDIR:
        return "it is a folder, and a file was expected: add a file name";
    case ENAMETOOLONG:
        return "the name is too long: choose a shorter one";
    default:
        return fmt::format("{}: check the name, or name another place", std::strerror(error));
    }
}

// bad_usage if another file name avoids the error, tool_failed for all other errors.
ExitCode code_of(int error) {
    switch (error) {
    case EACCES:
    case EEXIST:
    case EINVAL:
    case EISDIR:
    case ELOOP:
    case ENAMETOOLONG:
    case ENOENT:
    case ENOTDIR:
    case EPERM:
    case EROFS:
        return ExitCode::bad_usage;
    default:
        return ExitCode::tool_failed;
    }
}

FileError file_error(const char* doing, const fs::path& path, int error, bool makes_file) {
    return FileError(
        fmt::format("cannot {} '{}': {}", doing, path.string(), explain(error, path, makes_file)),
        code_of(error));
}

[[noreturn]] void fail_to_read(const fs::path& path, int error) {
    throw file_error("read", path, error, false);
}

[[noreturn]] void fail_to_write(const fs::path& path, int error) {
    throw file_error("write", path, error, true);
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
    if (!file.is_open()) fail_to_write(path, errno);
    if (const int error = write_all(file.get(), bytes)) fail_to_write(path, error);
    if (!file.close()) fail_to_write(path, errno);
}

struct Place {
    fs::path path;  // the name, or where it leads if it is a symbolic link
    bool is_device; // a device or a pipe, which is written directly
};

Place place_of(const std::string& name) {
    if (name.empty())
        throw FileError("cannot write a file without a name: give one", ExitCode::bad_usage);
    fs::path path(name);
    std::error_code error, ignored;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status) || !path.has_filename()) fail_to_write(path, EISDIR);
    if (error && error.value() != ENOENT) fail_to_write(path, error.value());
    if (fs::exists(status) && !fs::is_regular_file(status)) return {path, true};
    if (const fs::path real = fs::weakly_canonical(path, ignored);
        fs::is_symlink(path, ignored) && !real.empty())
        path = real;
    return {path, false};
}

// A new file beside `path`, under a temporary name that nobody else uses. The name is short, since
// `path` may have the longest name that is allowed. The destructor removes the file unless finish()
// was called.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& path) : path_(path) {
        // O_EXCL: never write into a file that someone else made.
        for (int attempt = 0; attempt < 100; ++attempt) {
            const fs::path name =
                path.parent_path() / fmt::format(".raylab-{}-{}.part", ::getpid(), attempt);
            unfinished_.emplace(name.c_str());
            file_.emplace(name, O_WRONLY | O_CREAT | O_EXCL);
            if (file_->is_open()) return;
            const int error = errno;
            unfinished_.reset();
            if (error != EEXIST) fail_to_write(path, error);
        }
        fail_to_write(path, EEXIST);
    }
    ~TemporaryFile() {
        if (unfinished_) ::unlink(unfinished_->path());
    }

    int get() const { return file_->get(); }

    // Flushes the file to the disk and renames it to its final name.
    void finish() {
        if (::fsync(get()) != 0) fail_to_write(path_, errno);
        if (!file_->close()) fail_to_write(path_, errno);
        if (::rename(unfinished_->path(), path_.c_str()) != 0) fail_to_write(path_, errno);
        unfinished_.reset();
    }

  private:
    fs::path path_;
    std::optional<UnfinishedFile> unfinished_;
    std::optional<Descriptor> file_;
};

} // namespace

FileError file_error(const fs::filesystem_error& error) {
    return file_error("use", error.path1(), error.code().value(), true);
}

void write_file(const std::string& name, std::string_view bytes) {
    const auto [path, is_device] = place_of(name);
    if (is_device) return write_directly(path, bytes);
    TemporaryFile file(path);
    if (const int error = write_all(file.get(), bytes)) fail_to_write(path, error);
    file.finish();
}

void prepare_output(const std::string& name) {
    const auto [path, is_device] = place_of(name);
    if (is_device) return;
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) throw file_error("make the folder", path.parent_path(), error.value(), true);
    const TemporaryFile probe(path);
}

std::string read_file(const std::string& name) {
    Descriptor file(name, O_RDONLY);
    if (!file.is_open()) fail_to_read(name, errno);
    std::string bytes;
    char block[1 << 16];
    for (;;) {
        const ssize_t n = ::read(file.get(), block, sizeof block);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail_to_read(name, errno);
        if (n == 0) return bytes;
        bytes.append(block, static_cast<std::size_t>(n));
    }
}

std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

} // namespace raylab
