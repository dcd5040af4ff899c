#include "grader/bench/machine.h"

#include "common/cli/process.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#if defined(__APPLE__)
#include <sys/sysctl.h>
#include <thread>
#else
#include <sched.h>
#endif

namespace raylab::bench {

namespace {

#if defined(__APPLE__)

std::string cpu_model() {
    char name[128] = "";
    std::size_t bytes = sizeof name;
    const int error = sysctlbyname("machdep.cpu.brand_string", name, &bytes, nullptr, 0);
    return error == 0 ? name : "unknown processor";
}

int usable_cores() { return static_cast<int>(std::thread::hardware_concurrency()); }

#else

std::string cpu_model() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

int usable_cores() {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

#endif

std::string git(const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {"git", "-C", RAYLAB_SOURCE_DIR};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = run_process(command, {10});
    return result.succeeded() ? result.output.substr(0, result.output.find('\n')) : "";
}

} // namespace

Machine this_machine() {
    Machine machine;
    machine.date = fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(std::time(nullptr)));
    machine.cpu = cpu_model();
    machine.cores = usable_cores();
    getloadavg(&machine.load, 1);
    machine.compiler = RAYLAB_COMPILER;
    machine.flags = RAYLAB_BUILD_FLAGS;
    machine.commit = git({"rev-parse", "--short=12", "HEAD"});
    machine.changed = !git({"status", "--porcelain", "--untracked-files=no"}).empty();
    return machine;
}

std::string to_string(const Machine& m) {
    return fmt::format("{} UTC, {}, {} cores, load {:.2f} before the run, {}, {}, commit {}{}",
                       m.date, m.cpu, m.cores, m.load, m.compiler, m.flags,
                       m.commit.empty() ? "unknown" : m.commit,
                       m.changed ? " with local changes" : "");
}

} // namespace raylab::bench
