#include "grader/bench/machine.h"

#include "common/cli/process.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <fstream>
#include <sched.h>

namespace raylab::bench {

namespace {

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
    std::ifstream("/proc/loadavg") >> machine.load;
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
