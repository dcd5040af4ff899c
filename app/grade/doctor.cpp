// raylab doctor: what this machine can do, what is missing for which command, and how to get it.
#include "app/grade/commands.h"
#include "grader/sandbox/sandbox.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <unistd.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

// Something that commands need, or use if it is there.
struct Part {
    std::string name, needed_for;
    std::string get;  // how to get it on Debian and Ubuntu
    std::string path; // where it is; empty: it is not there
};

std::string on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (const std::string file = folder + "/" + program; access(file.c_str(), X_OK) == 0)
            return file;
    return "";
}

std::string first_there(const std::vector<std::string>& files) {
    const auto found = std::find_if(files.begin(), files.end(), [](const std::string& file) {
        std::error_code error;
        return fs::exists(file, error);
    });
    return found == files.end() ? "" : *found;
}

std::string or_else(const std::string& path, const std::string& other) {
    return path.empty() ? other : path;
}

std::vector<Part> parts() {
    const auto program = [](const std::string& name, const std::string& needed_for,
                            const std::string& package) {
        return Part{name, needed_for, "apt-get install " + package, on_path(name)};
    };
    const char* display = std::getenv("DISPLAY");
    return {
        program("c++", "everything", "g++"),
        program("cmake", "everything", "cmake"),
        program("ninja", "everything", "ninja-build"),
        program("ccache", "quick builds", "ccache"),
        program("bwrap", "grade: the sandbox of tier 1", "bubblewrap"),
        program("objdump", "grade: looks at a submission's objects", "binutils"),
        program("gdb", "debug", "gdb"),
        program("clang++", "run: tells host code in kernels", "clang"),
        {"nvcc", "CUDA: RAYLAB_PRESET=cuda",
         "apt-get install nvidia-cuda-toolkit, or NVIDIA's own packages",
         or_else(on_path("nvcc"), first_there({"/usr/local/cuda/bin/nvcc"}))},
        {"a GPU", "CUDA: running kernels on it", "an NVIDIA GPU and its driver",
         first_there({"/dev/nvidiactl", "/dev/dxg"})},
        {"a display", "viewer", "a desktop, or ssh -X", display ? display : ""},
        {"GLFW", "viewer", "apt-get install libglfw3-dev libglew-dev",
         first_there({"/usr/include/GLFW/glfw3.h"})},
        program("blender", "bench: Cycles as a peer", "blender"),
        {"Embree", "bench-rays: a peer", "apt-get install libembree-dev",
         first_there({"/usr/include/embree4/rtcore.h", "/usr/include/embree3/rtcore.h"})},
        program("python3", "bench: Mitsuba as a peer (pip install mitsuba)", "python3"),
        program("chromium", "tests of pages", "chromium"),
    };
}

// The median of a few runs of a program that does nothing, in milliseconds.
double overhead(const sandbox::Isolation& isolation) {
    std::vector<double> all;
    for (int i = 0; i < 7; ++i)
        all.push_back(1e3 * sandbox::run({"/usr/bin/true"}, {}, isolation).seconds);
    std::sort(all.begin(), all.end());
    return all[all.size() / 2];
}

ExitCode run_doctor(bool as_json) {
    const sandbox::Isolation& isolation = sandbox::best_isolation();
    const double milliseconds = overhead(isolation);
    if (as_json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const Part& part : parts())
            list.push_back({{"name", part.name},
                            {"there", !part.path.empty()},
                            {"path", part.path},
                            {"needed_for", part.needed_for},
                            {"get", part.get}});
        const nlohmann::ordered_json json = {{"sandbox",
                                              {{"tier", static_cast<int>(isolation.tier)},
                                               {"layers", isolation.layers},
                                               {"missing", isolation.missing},
                                               {"milliseconds_a_run", milliseconds}}},
                                             {"parts", list}};
        fmt::print("{}\n", json.dump(2));
        return ExitCode::success;
    }
    fmt::print("sandbox of grade: {}\n", isolation.sentence());
    fmt::print("    a run takes {:.0f} ms more\n", milliseconds);
    if (isolation.tier == sandbox::Tier::limited)
        fmt::print("    UNSANDBOXED: submissions run as you do, and hidden scenes are not drawn. "
                   "Run the grader "
                   "as root,\n    or install bubblewrap where user namespaces are allowed\n");
    for (const Part& part : parts())
        fmt::print("{:8} {:10} {}{}\n", part.path.empty() ? "missing" : "there", part.name,
                   part.needed_for, part.path.empty() ? "; get it: " + part.get : "");
    return ExitCode::success;
}

} // namespace

Run add_doctor(CLI::App& app, const GraderTree&) {
    auto as_json = std::make_shared<bool>(false);
    app.description(
        "Say what this machine can do, what is missing for which command, and how to get it.");
    app.add_flag("--json", *as_json, "print a JSON object");
    app.footer("Examples:\n  raylab doctor\n  raylab doctor --json");
    return [as_json] { return run_doctor(*as_json); };
}

} // namespace raylab::app
