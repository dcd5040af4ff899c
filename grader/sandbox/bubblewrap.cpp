#include "grader/sandbox/bubblewrap.h"

namespace raylab::sandbox {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

void add(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

// On most systems /bin, /lib and the like are links into /usr.
void add_system(Words& words) {
    for (const fs::path& folder : system_folders()) {
        std::error_code error;
        if (fs::is_symlink(folder, error))
            add(words, {"--symlink", fs::read_symlink(folder, error), folder});
        else
            add(words, {"--ro-bind", folder, folder});
    }
}

} // namespace

std::string bubblewrap_program() {
    for (const char* path : {"/usr/bin/bwrap", "/usr/local/bin/bwrap", "/bin/bwrap"}) {
        std::error_code error;
        if (fs::exists(path, error)) return path;
    }
    return "";
}

std::vector<fs::path> system_folders() {
    std::vector<fs::path> there;
    std::error_code error;
    for (const char* path :
         {"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/etc/ld.so.cache",
          "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/alternatives"})
        if (fs::exists(path, error)) there.emplace_back(path);
    return there;
}

Words in_bubblewrap(const Words& command, const SandboxOptions& options, int filter, int status) {
    // --disable-userns: else a program could make namespaces of its own, in which it is root.
    Words words = {bubblewrap_program(),
                   "--unshare-user",
                   "--unshare-ipc",
                   "--unshare-pid",
                   "--unshare-net",
                   "--unshare-uts",
                   "--unshare-cgroup-try",
                   "--disable-userns",
                   "--die-with-parent",
                   "--new-session",
                   "--clearenv",
                   "--cap-drop",
                   "ALL",
                   "--uid",
                   "1000",
                   "--gid",
                   "1000",
                   "--hostname",
                   "lab",
                   "--seccomp",
                   std::to_string(filter),
                   "--json-status-fd",
                   std::to_string(status)};
    add_system(words);
    const std::string size = std::to_string(options.limits.private_files);
    add(words, {"--proc", "/proc", "--dev", "/dev", "--size", size, "--tmpfs", "/dev/shm",
                "--remount-ro", "/dev", "--size", size, "--tmpfs", "/tmp"});
    for (const Bind& bind : options.readable) add(words, {"--ro-bind", bind.from, bind.to});
    for (const Bind& bind : options.writable) add(words, {"--bind", bind.from, bind.to});
    add(words, {"--remount-ro", "/", "--chdir", options.folder});
    for (const auto& [name, value] : options.environment) add(words, {"--setenv", name, value});
    words.push_back("--");
    add(words, command);
    return words;
}

} // namespace raylab::sandbox
