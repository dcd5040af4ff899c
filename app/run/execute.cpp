// The environment of a run, and what is left of it; see execute.h.
#include "app/run/execute.h"

#include "common/cli/files.h"
#include "common/cli/progress.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <sstream>

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

// What the sanitizers wrote into files of their own.
std::string sanitizer_logs(const fs::path& folder) {
    std::string text;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with("sanitizer."))
            text += read_file(entry.path().string());
    return text;
}

// UndefinedBehaviorSanitizer writes to standard error whatever it is told. The rest is the
// program's.
std::string without_sanitizer(const std::string& errors) {
    static const std::regex sanitizer(
        R"(.*: runtime error: .*|0x[0-9a-f]+: note: .*|( [0-9a-f?]{2}| )+|\s*\^\s*)");
    std::istringstream lines(errors);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (line.empty() || !std::regex_match(line, sanitizer)) kept += line + "\n";
    return kept;
}

} // namespace

Execution execute(const Mode& mode, const fs::path& program, const std::string& order,
                  const RunOptions& options, Output show) {
    const fs::path folder = program.parent_path(), findings = folder / "findings.jsonl";
    const fs::path errors = folder / "errors.txt";
    for (const auto& entry : fs::directory_iterator(folder)) // of an earlier run
        if (entry.path() != program && !entry.is_directory() && entry.path().extension() != ".o" &&
            entry.path().extension() != ".cpp")
            fs::remove(entry.path());
    const double limit = options.time_limit * mode.patience;
    const bool compares = options.order.empty() && !order.empty(); // all orders
    Execution execution{compares ? "order" : mode.name, order, {}, {}, {}, {}, {}};
    Environment environment;
    environment.set("RAYLAB_FINDINGS", findings.string());
    environment.set("RAYLAB_TIME_LIMIT", fmt::format("{}", limit));
    environment.set("RAYLAB_REPORTS", "0");
    environment.set("RAYLAB_MODE", execution.mode);
    if (mode.name == "memory") environment.set("RAYLAB_COUNT", "memory");
    if (!order.empty()) {
        environment.set("RAYLAB_ORDER", order);
        environment.set("RAYLAB_WORKERS", "1"); // nothing else decides who comes first
    }
    const std::string log = "log_path=" + (folder / "sanitizer").string();
    const std::string symbols = options.raw ? ":symbolize=1" : ":symbolize=0";
    environment.prepend("ASAN_OPTIONS",
                        log + symbols + ":detect_leaks=0:allocator_may_return_null=1");
    environment.prepend("UBSAN_OPTIONS", log);
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
                                              .errors = ProcessOptions::Errors::to_file,
                                              .error_file = errors});
    progress.clear();
    if (!execution.process.started)
        throw std::runtime_error("the program " + why_failed(execution.process));
    const std::string said = read_file(errors.string());
    if (show != Output::hidden) fmt::print(stderr, "{}", without_sanitizer(said));
    execution.raw = said + sanitizer_logs(folder);
    if (fs::exists(findings)) {
        simt::FindingsFile file = simt::parse_findings(read_file(findings.string()));
        execution.findings = simt::folded(file.findings);
        execution.costs = std::move(file.costs);
        if (file.summary && file.summary->launches > 0) execution.summary = file.summary;
    }
    return execution;
}

} // namespace raylab::app
