#include "grader/sandbox/cgroup.h"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace raylab::sandbox {

namespace fs = std::filesystem;

namespace {

bool write_value(const fs::path& file, const std::string& value) {
    std::ofstream stream(file);
    stream << value << std::flush;
    return stream.good();
}

std::uint64_t read_number(const fs::path& file) {
    std::uint64_t number = 0;
    std::ifstream(file) >> number;
    return number;
}

// The number behind a key: "oom_kill 1".
std::uint64_t read_key(const fs::path& file, const std::string& key) {
    std::ifstream stream(file);
    std::string name;
    for (std::uint64_t number; stream >> name >> number;)
        if (name == key) return number;
    return 0;
}

// This process's group: that of a controller of version 1, or with "" that of version 2. Both are
// lines of /proc/self/cgroup, "4:memory:/path" and "0::/path". Empty: there is none.
fs::path own_group(const std::string& controller) {
    std::ifstream lines("/proc/self/cgroup");
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == line.npos) continue;
        std::istringstream names(line.substr(first + 1, second - first - 1));
        std::string name;
        bool found = controller.empty() && second == first + 1;
        while (std::getline(names, name, ',')) found = found || name == controller;
        if (!found) continue;
        const fs::path mount = fs::path("/sys/fs/cgroup") / controller;
        // In a container the path may be the host's, and the mount is the own group itself.
        std::error_code error;
        const fs::path inside = mount / fs::path(line.substr(second + 1)).relative_path();
        if (fs::exists(inside / "cgroup.procs", error)) return inside;
        if (fs::exists(mount / "cgroup.procs", error)) return mount;
    }
    return {};
}

fs::path make_below(const fs::path& parent, std::string& trouble) {
    static std::atomic<int> count = 0;
    if (parent.empty()) return {};
    const fs::path group = parent / fmt::format("raylab-{}-{}", getpid(), ++count);
    std::error_code error;
    if (fs::create_directory(group, error)) return group;
    trouble = fmt::format("{}: {}", parent.string(), error ? error.message() : "is in use");
    return {};
}

// A process that was killed leaves its group a moment later.
void remove_group(const fs::path& group) {
    for (int tries = 0;
         !group.empty() && rmdir(group.c_str()) != 0 && errno == EBUSY && tries < 200; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

} // namespace

Cgroup::Cgroup(std::uint64_t memory_bytes, int processes) {
    const std::string bytes = std::to_string(memory_bytes), number = std::to_string(processes);
    std::error_code error;
    version_2_ = fs::exists("/sys/fs/cgroup/cgroup.controllers", error);
    if (version_2_) {
        const fs::path own = own_group("");
        // Fails where this process is in that very group: version 2 wants processes in leaves.
        write_value(own / "cgroup.subtree_control", "+memory +pids");
        const fs::path group = make_below(own, trouble_);
        if (!group.empty() && fs::exists(group / "memory.max")) memory_ = group;
        if (!group.empty() && fs::exists(group / "pids.max")) pids_ = group;
        if (!group.empty() && memory_.empty() && pids_.empty()) {
            remove_group(group);
            trouble_ = own.string() + " gives no controllers to groups below it";
        }
    } else {
        memory_ = make_below(own_group("memory"), trouble_);
        pids_ = make_below(own_group("pids"), trouble_);
        if (memory_.empty() && pids_.empty() && trouble_.empty())
            trouble_ = "no controllers below /sys/fs/cgroup";
    }
    if (memory_bytes > 0 && memory()) {
        const bool limited =
            write_value(memory_ / (version_2_ ? "memory.max" : "memory.limit_in_bytes"), bytes);
        // Swap counts too, where it is counted.
        write_value(memory_ / (version_2_ ? "memory.swap.max" : "memory.memsw.limit_in_bytes"),
                    version_2_ ? "0" : bytes);
        if (!limited)
            trouble_ = "the memory limit cannot be set", remove_group(memory_), memory_.clear();
    }
    if (processes > 0 && pids() && !write_value(pids_ / "pids.max", number))
        trouble_ = "the limit of processes cannot be set", remove_group(pids_), pids_.clear();
}

Cgroup::~Cgroup() {
    kill_all();
    remove_group(memory_);
    if (pids_ != memory_) remove_group(pids_);
}

void Cgroup::add(pid_t process) const {
    if (memory()) write_value(memory_ / "cgroup.procs", std::to_string(process));
    if (pids() && pids_ != memory_) write_value(pids_ / "cgroup.procs", std::to_string(process));
}

// Again and again, since what is killed may have forked a moment before.
void Cgroup::kill_all() const {
    for (int tries = 0; tries < 1000; ++tries) {
        bool any = false;
        for (const fs::path& group : {pids_, memory_}) {
            std::ifstream processes(group / "cgroup.procs");
            for (pid_t process; processes >> process;) any = true, kill(process, SIGKILL);
        }
        if (!any) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

std::uint64_t Cgroup::peak_memory() const {
    return memory()
               ? read_number(memory_ / (version_2_ ? "memory.peak" : "memory.max_usage_in_bytes"))
               : 0;
}

bool Cgroup::out_of_memory() const {
    return memory() && read_key(memory_ / (version_2_ ? "memory.events" : "memory.oom_control"),
                                "oom_kill") > 0;
}

bool Cgroup::out_of_pids() const { return pids() && read_key(pids_ / "pids.events", "max") > 0; }

} // namespace raylab::sandbox
