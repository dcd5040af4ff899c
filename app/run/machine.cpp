// The engine's build folders; see machine.h. A folder is configured by cmake/configure.sh, which
// also notices a tree that was copied or moved.
#include "app/run/machine.h"

#include "app/run/process_words.h"
#include "common/cli/files.h"
#include "common/cli/process.h"
#include "common/cli/progress.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fcntl.h>
#include <sstream>
#include <sys/file.h>
#include <unistd.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

constexpr double build_limit_seconds = 1800; // a first build, on a slow machine

// One raylab at a time builds in a folder; the others wait for it.
class Lock {
  public:
    explicit Lock(const fs::path& file)
        : file_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (file_ >= 0) flock(file_, LOCK_EX);
    }
    ~Lock() {
        if (file_ >= 0) close(file_);
    }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int file_;
};

ProcessResult run(const Tree& tree, const std::string& what,
                  const std::vector<std::string>& words) {
    Progress progress(what, 1, "steps", 1);
    const auto tick = [&progress] { progress.tick(); };
    const ProcessResult result = run_process(
        words, {.limit_seconds = build_limit_seconds, .folder = tree.root, .tick = tick});
    if (!result.succeeded())
        throw std::runtime_error(fmt::format("{} failed, {}:\n{}what to do: look at the lines "
                                             "above; `./raylab test` tests raylab itself",
                                             what, why_failed(result), last_lines(result.output)));
    return result;
}

// The command of those that build the program in which both words stand.
std::string command_with(const std::string& commands, const std::string& one,
                         const std::string& other) {
    std::istringstream lines(commands);
    for (std::string line; std::getline(lines, line);)
        if (line.find(one) != line.npos && line.find(other) != line.npos) return line;
    throw std::runtime_error("the CPU machine's build has no command with '" + one +
                             "': remove the folders build/machine-* and try again");
}

std::string cached(const fs::path& cache, const std::string& name) {
    std::istringstream lines(read_file(cache.string()));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(name + ":")) return line.substr(line.find('=') + 1);
    return {};
}

// Of a mode, for the compiler that CMake takes: the one that the environment's CXX names, or the
// usual one. A folder keeps the compiler that it was configured with.
fs::path folder_of(const Tree& tree, const Mode& mode) {
    const char* compiler = std::getenv("CXX");
    const std::string name = compiler ? fs::path(compiler).filename().string() : "";
    return tree.root / "build" / (mode.build() + (name.empty() ? "" : "-" + name));
}

} // namespace

const Mode& mode_named(const std::string& name) {
    // What a student writes is compiled with assert(), and so that its lines are still there. Local
    // arrays that are larger than the guard below a stack must not reach beyond it.
    static const std::string debug =
        " -UNDEBUG -g1 -fno-omit-frame-pointer -fstack-clash-protection -w -Wno-error";
    static const Mode modes[] = {
        {"plain", "cpu", debug, 1},
        {"bounds", "check",
         debug + " -O1 -fsanitize=float-cast-overflow "
                 "-fsanitize-recover=undefined,float-cast-overflow",
         3},
        {"watch", "watch", debug + " -O1", 6},
        {"races", "check-threads", debug + " -O1", 6},
        {"gdb", "cpu", " -UNDEBUG -O0 -g -w -Wno-error", 1, "plain"},
        {"memory", "watch", debug + " -O1", 12, "watch"},
    };
    for (const Mode& mode : modes)
        if (mode.name == name) return mode;
    throw std::logic_error("no mode " + name);
}

Machine build_machine(const Tree& tree, const Mode& mode) {
    const fs::path folder = folder_of(tree, mode);
    fs::create_directories(folder.parent_path());
    const Lock lock(folder.string() + ".lock");
    const std::string which = "the CPU machine (" + mode.name + ")";
    const bool has_ccache = run_process({"ccache", "--version"}, {.limit_seconds = 10}).succeeded();
    run(tree, "configuring " + which,
        {(tree.root / "cmake/configure.sh").string(), folder.string(), "--preset", mode.preset,
         "-DRAYLAB_TESTS=OFF", "-DRAYLAB_OVERLAY=",
         std::string("-DCMAKE_CXX_COMPILER_LAUNCHER=") + (has_ccache ? "ccache" : "")});
    run(tree, "building " + which,
        {"cmake", "--build", folder.string(), "--target", "raylab_simt", "simt_rewrite"});
    const std::string ninja = cached(folder / "CMakeCache.txt", "CMAKE_MAKE_PROGRAM");
    const std::string commands = run(tree, "asking " + which,
                                     {ninja.empty() ? "ninja" : ninja, "-C", folder.string(), "-t",
                                      "commands", "simt_program"})
                                     .output;
    return {&mode, folder, folder / "common/simt/simt_rewrite",
            command_with(commands, "empty_cu.cpp", " -c "),
            command_with(commands, "empty_cu.cpp.o", " -o common/simt/simt_program")};
}

} // namespace raylab::app
