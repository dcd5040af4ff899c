// The environment of a run, and what is left of it; see execute.h.
#include "app/run/execute.h"

#include "common/cli/files.h"
#include "common/cli/progress.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

// Variables of the environment, for the programs that are started meanwhile.
class Environment {
  public:
    void set(const std::string& name, const std::string& value) {
        setenv(name.c_str(), value.c_str(), 1);
        names_.push_back(name);
    }
    // In front of what the user has set there: the later one holds.
    void prepend(const std::string& name, const std::string& value) {
        const char* user = std::getenv(name.c_str());
        before_.emplace_back(name, user ? std::optional<std::string>(user) : std::nullopt);
        setenv(name.c_str(), (user ? value + ":" + user : value).c_str(), 1);
    }
    Environment() = default;
    ~Environment() {
        for (const std::string& name : names_) unsetenv(name.c_str());
        for (const auto& [name, value] : before_)
            value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    std::vector<std::string> names_;
    std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

// What the sanitizers wrote, and no longer on disk.
std::string take_logs(const fs::path& folder) {
    std::string text;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with("sanitizer.")) {
            text += read_file(entry.path().string());
            fs::remove(entry.path());
        }
    return text;
}

} // namespace

Execution execute(const Mode& mode, const fs::path& program, const std::string& order,
                  const RunOptions& options, Output show) {
    const fs::path folder = program.parent_path(), findings = folder / "findings.jsonl";
    fs::remove(findings);
    const double limit = options.time_limit * mode.patience;
    Execution execution{order.empty() ? mode.name : "order", order, {}, {}, {}, {}};
    Environment environment;
    environment.set("RAYLAB_FINDINGS", findings.string());
    environment.set("RAYLAB_TIME_LIMIT", fmt::format("{}", limit));
    environment.set("RAYLAB_REPORTS", "0");
    environment.set("RAYLAB_MODE", execution.mode);
    if (!order.empty()) {
        environment.set("RAYLAB_ORDER", order);
        environment.set("RAYLAB_WORKERS", "1"); // nothing else decides who comes first
    }
    const std::string log = "log_path=" + (folder / "sanitizer").string();
    const std::string symbols = options.raw ? ":symbolize=1" : ":symbolize=0";
    environment.prepend("ASAN_OPTIONS",
                        log + symbols + ":detect_leaks=0:allocator_may_return_null=1");
    environment.prepend("UBSAN_OPTIONS", log + ":print_stacktrace=1");
    environment.prepend("TSAN_OPTIONS", log + symbols + ":history_size=4:exitcode=0");

    std::vector<std::string> command = {program.string()};
    command.insert(command.end(), options.arguments.begin(), options.arguments.end());
    Progress progress(
        fmt::format("running ({}{})", execution.mode, order.empty() ? "" : ", " + order), 1,
        "programs", 1);
    std::size_t shown = 0;
    const auto watch = [&](const std::string& output) {
        if (show == Output::hidden) return;
        progress.clear();
        FILE* to = show == Output::shown ? stdout : stderr;
        if (output.size() < shown) shown = 0; // the oldest was dropped
        std::fwrite(output.data() + shown, 1, output.size() - shown, to);
        std::fflush(to);
        shown = output.size();
    };
    execution.process = run_process(command, {.limit_seconds = limit + 10,
                                              .watch = watch,
                                              .tick = [&] { progress.tick(); },
                                              .errors = show == Output::hidden
                                                            ? ProcessOptions::Errors::dropped
                                                            : ProcessOptions::Errors::passed_on});
    if (!execution.process.started)
        throw std::runtime_error("the program " + why_failed(execution.process));
    execution.raw = take_logs(folder);
    if (fs::exists(findings)) {
        simt::FindingsFile file = simt::parse_findings(read_file(findings.string()));
        execution.findings = simt::folded(file.findings);
        if (file.summary && file.summary->launches > 0) execution.summary = file.summary;
    }
    return execution;
}

} // namespace raylab::app
