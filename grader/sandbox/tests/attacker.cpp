// What a hostile program tries. Its first word says what; it prints what came of it.
#include <arpa/inet.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <sched.h>
#include <string>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace {

int say(const char* what, long result) {
    std::printf("%s: %s\n", what, result >= 0 ? "worked" : std::strerror(errno));
    return result >= 0 ? 1 : 0;
}

// Memory that is written to is memory that is taken.
void touch(char* bytes, std::size_t n) {
    for (std::size_t i = 0; i < n; i += 4096) bytes[i] = 1;
}

int allocate() {
    for (;;) {
        char* block = static_cast<char*>(
            mmap(nullptr, 16 << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        if (block == MAP_FAILED) return say("allocate", -1);
        touch(block, 16 << 20);
    }
}

int fork_bomb() {
    for (int i = 0; i < 4000; ++i) {
        const pid_t child = fork();
        if (child < 0) return say("fork", -1), 3;
        if (child == 0) pause();
    }
    return say("4000 processes", 1);
}

int thread_bomb() {
    std::vector<std::thread> threads;
    for (int i = 0; i < 4000; ++i) threads.emplace_back([] { pause(); });
    return say("4000 threads", 1);
}

int fill(const std::string& folder, bool many_files) {
    const std::vector<char> block(1 << 20, 'x');
    for (int i = 0; i < 100000; ++i) {
        const std::string name = folder + "/" + std::to_string(many_files ? i : i / 2);
        const int file = open(name.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
        if (file < 0 || (!many_files && write(file, block.data(), block.size()) < 0))
            return say("fill", -1);
        close(file);
    }
    return say("fill", 1);
}

int one_large_file(const std::string& folder) {
    const std::vector<char> block(1 << 20, 'x');
    const int file = open((folder + "/large").c_str(), O_CREAT | O_WRONLY, 0600);
    for (int i = 0; i < 100000; ++i)
        if (write(file, block.data(), block.size()) < 0) return say("large file", -1);
    return say("large file", 1);
}

int list_handles() {
    DIR* folder = opendir("/proc/self/fd");
    if (!folder) return say("/proc/self/fd", -1);
    while (const dirent* entry = readdir(folder))
        if (const int number = std::atoi(entry->d_name); number > 2 && number != dirfd(folder))
            std::printf("handle %d\n", number);
    return 0;
}

// A grandchild in a session of its own, which goes on when its parent has ended.
int stay(const std::string& file) {
    if (fork() == 0) {
        setsid();
        if (fork() != 0) _exit(0);
        for (int i = 0; i < 600; ++i) {
            usleep(100000);
            const int handle = open(file.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
            [[maybe_unused]] const ssize_t n = write(handle, "still here\n", 11);
            close(handle);
        }
    }
    return 0;
}

int connect_out() {
    int worked = 0;
    for (const int kind : {SOCK_STREAM, SOCK_DGRAM}) {
        const int handle = socket(AF_INET, kind, 0);
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(53);
        inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
        worked += say(kind == SOCK_STREAM ? "tcp" : "udp",
                      handle < 0
                          ? -1
                          : connect(handle, reinterpret_cast<sockaddr*>(&address), sizeof address));
    }
    worked += say("netlink", socket(AF_NETLINK, SOCK_RAW, 0));
    worked += say("unix", socket(AF_UNIX, SOCK_STREAM, 0));
    return worked;
}

int open_up() {
    return say("unshare", unshare(CLONE_NEWUSER)) + say("ptrace", ptrace(PTRACE_TRACEME, 0, 0, 0)) +
           say("io_uring", syscall(425, 4, nullptr)) + say("bpf", syscall(SYS_bpf, 0, nullptr, 0)) +
           say("keyctl", syscall(SYS_keyctl, 0, -3, 0)) + say("setuid", setuid(0)) +
           say("mkdir /usr/x", mkdir("/usr/x", 0700)) + say("mkdir /x", mkdir("/x", 0700));
}

} // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "", where = argc > 2 ? argv[2] : "/tmp";
    if (what == "allocate") return allocate();
    if (what == "fork") return fork_bomb();
    if (what == "threads") return thread_bomb();
    if (what == "fill") return fill(where, false);
    if (what == "many") return fill(where, true);
    if (what == "large") return one_large_file(where);
    if (what == "handles") return list_handles();
    if (what == "stay") return stay(where);
    if (what == "connect") return connect_out();
    if (what == "open") return open_up();
    if (what == "loop")
        for (volatile bool on = true; on;) {
        }
    if (what == "sleep")
        for (;;) pause();
    if (what == "print")
        for (;;) std::puts("all tests passed");
    if (what == "crash") std::abort();
    if (what == "exit") return std::atoi(where.c_str());
    if (what == "environment")
        for (char** variable = environ; *variable; ++variable) std::puts(*variable);
    if (what == "kill") {
        const int all = kill(-1, SIGKILL); // spares the caller
        return say("kill everybody", all) + say("kill parent", kill(getppid(), SIGKILL));
    }
    if (what == "read") {
        const int file = open(where.c_str(), O_RDONLY);
        return say("read", file);
    }
    if (what == "write") {
        const int file = open(where.c_str(), O_WRONLY | O_CREAT, 0600);
        return say("write", file < 0 ? -1 : write(file, "x", 1));
    }
    if (what == "says") {
        char text[64] = {};
        const ssize_t n = read(3, text, sizeof text);
        return write(4, text, n > 0 ? static_cast<std::size_t>(n) : 0) == n ? 0 : 1;
    }
    return 0;
}
