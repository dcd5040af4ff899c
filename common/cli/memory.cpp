// proc(5), cgroups(7): version 2 has memory.max and memory.current in each folder from the
// process's group up to the root, version 1 memory.limit_in_bytes and memory.usage_in_bytes.
#include "common/cli/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <sys/resource.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace raylab {

namespace {

using Bytes = std::optional<std::uint64_t>;

// The number behind `key` in a file of lines "key number"; with an empty key, the file's first.
Bytes number_in(const std::string& file, const std::string& key = "") {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(key)) continue;
        std::uint64_t number = 0;
        if (std::istringstream(line.substr(key.size())) >> number) return number;
        return {}; // "max"
    }
    return {};
}

std::uint64_t left(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

// The memory that a control group leaves. Cached files count as used, but the kernel gives their
// memory back when a program needs it.
Bytes left_by_group(const std::string& folder, const char* limit, const char* usage,
                    const char* file_pages) {
    const Bytes most = number_in(folder + limit), used = number_in(folder + usage);
    if (!most || !used) return {};
    const std::uint64_t files = number_in(folder + "/memory.stat", file_pages).value_or(0);
    return left(*most, left(*used, files));
}

// The tightest of the process's groups. Lines of /proc/self/cgroup are "0::/path" in version 2, and
// "4:memory:/path" in version 1.
Bytes left_by_groups(const std::string& root) {
    Bytes least;
    const auto take = [&](const Bytes& bytes) {
        if (bytes) least = std::min(bytes, least ? least : bytes);
    };
    std::ifstream groups(root + "/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == line.npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        for (std::string path = line.substr(second + 1);; path.erase(path.rfind('/'))) {
            if (path == "/") path.clear();
            if (controllers.empty())
                take(left_by_group(root + "/sys/fs/cgroup" + path, "/memory.max", "/memory.current",
                                   "inactive_file "));
            else if (controllers.find("memory") != controllers.npos)
                take(left_by_group(root + "/sys/fs/cgroup/memory" + path, "/memory.limit_in_bytes",
                                   "/memory.usage_in_bytes", "total_inactive_file "));
            if (path.rfind('/') == path.npos) break;
        }
    }
    return least;
}

// What `ulimit -v` leaves.
Bytes left_of_address_space(const std::string& root) {
    struct rlimit limit {};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
    const std::uint64_t used = number_in(root + "/proc/self/status", "VmSize:").value_or(0) << 10;
    return left(limit.rlim_cur, used);
}

} // namespace

AvailableMemory available_memory(const std::string& root) {
    AvailableMemory available{std::numeric_limits<std::uint64_t>::max(), "no limit is known"};
    const auto limit = [&](const Bytes& bytes, const char* who) {
        if (bytes && *bytes < available.bytes) available = {*bytes, who};
    };
    if (const Bytes kib = number_in(root + "/proc/meminfo", "MemAvailable:"))
        limit(*kib << 10, "the machine has no more free");
    limit(left_by_groups(root), "the limit of this container or job");
    limit(left_of_address_space(root), "the limit of `ulimit -v`");
    return available;
}

void spare_address_space() {
#ifdef M_ARENA_MAX
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        mallopt(M_ARENA_MAX, 1);
#endif
}

std::uint64_t peak_memory() {
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
#if defined(__APPLE__)
    return static_cast<std::uint64_t>(usage.ru_maxrss); // bytes there, KiB elsewhere
#else
    return static_cast<std::uint64_t>(usage.ru_maxrss) << 10;
#endif
}

std::string human_bytes(double bytes) {
    if (bytes < 1 << 10) return fmt::format("{:.0f} bytes", bytes);
    if (bytes < 1 << 20) return fmt::format("{:.1f} KiB", bytes / (1 << 10));
    if (bytes < 1 << 30) return fmt::format("{:.1f} MiB", bytes / (1 << 20));
    return fmt::format("{:.2f} GiB", bytes / (1 << 30));
}

} // namespace raylab
