// The modes one after the other; see run.h.
#include "app/run/run.h"

#include "app/run/build_program.h"
#include "app/run/host_code.h"
#include "app/run/merge.h"
#include "app/run/order.h"
#include "app/run/work_folder.h"
#include "common/cli/exit_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>

namespace raylab::app {

namespace {

bool has(const std::vector<simt::Finding>& findings, const std::string& kind) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const simt::Finding& finding) { return finding.kind == kind; });
}

// A kernel that does not end would not end in any other mode either.
bool is_pointless_to_go_on(const Execution& execution) {
    return execution.process.timed_out || has(execution.findings, "endless-loop");
}

std::string asked_order(const RunOptions& options) {
    return options.order == "random" ? fmt::format("random:{}", options.seed) : options.order;
}

class Session {
  public:
    Session(const Tree& tree, const RunOptions& options)
        : tree_(tree), options_(options), work_(options.keep) {
        result_.sources = sources_of(options.inputs);
    }

    Result run() {
        const std::string& machine = options_.machine;
        const bool all = machine == "all";
        // clang reads while g++ compiles.
        host_code_ = std::async(std::launch::async, host_code_in_kernels, std::cref(tree_),
                                std::cref(options_), std::cref(result_.sources));
        if (machine == "order") {
            if (build("plain")) compare_orders();
        } else {
            for (const char* mode : {"plain", "bounds", "races", "watch", "memory"})
                if (is_asked_for(mode) && !(build(mode) && run_once())) return finish();
            if (all && build("plain")) compare_orders();
        }
        return finish();
    }

  private:
    // What the thread sanitizer finds, the machine that watches everything finds too, and faster,
    // but on Linux alone.
    bool is_asked_for(const std::string& mode) const {
#if defined(__linux__)
        const std::string left_out = "races";
#else
        const std::string left_out = "watch";
#endif
        return options_.machine == mode ||
               (options_.machine == "all" && mode != left_out && mode != "memory");
    }

    bool build(const std::string& name) {
        mode_ = &mode_named(name);
        if (program_of_plain_ && name == "plain") {
            program_ = *program_of_plain_;
            return true;
        }
        const BuiltProgram built = build_program(tree_, build_machine(tree_, *mode_),
                                                 result_.sources, options_, work_.path() / name);
        if (built.file.empty()) {
            result_.executions.clear();
            result_.findings = built.findings;
            result_.compiler = built.words;
            return false;
        }
        program_ = built.file;
        if (name == "plain") program_of_plain_ = program_;
        return true;
    }

    // False: there is no point in going on.
    bool run_once() {
        return add(execute(*mode_, program_, asked_order(options_), options_, show()));
    }

    void compare_orders() {
        std::vector<Execution> runs;
        for (const std::string& order :
             {std::string("forward"), std::string("forward"), std::string("reverse"),
              fmt::format("random:{}", options_.seed)}) {
            runs.push_back(execute(*mode_, program_, order, options_, show()));
            if (!add(runs.back())) return;
            runs.back().order = order;
        }
        std::vector<simt::Finding> found = order_dependence(runs, result_.sources.front());
        result_.executions.back().findings.insert(result_.executions.back().findings.end(),
                                                  found.begin(), found.end());
    }

    // What the program prints is shown once; where the report is for programs, beside it.
    Output show() const {
        if (!result_.executions.empty()) return Output::hidden;
        return options_.format == Format::text ? Output::shown : Output::to_errors;
    }

    bool add(const Execution& execution) {
        result_.executions.push_back(execution);
        if (options_.raw) fmt::print(stderr, "{}", execution.raw);
        return !is_pointless_to_go_on(execution);
    }

    Result finish() {
        HostCode host_code = host_code_.get();
        if (!result_.executions.empty()) {
            result_.unchecked = host_code.unchecked;
            std::vector<simt::Finding>& found = result_.executions.front().findings;
            found.insert(found.begin(), host_code.findings.begin(), host_code.findings.end());
            result_.findings = merged(result_.executions);
        }
        return std::move(result_);
    }

    const Tree& tree_;
    const RunOptions& options_;
    WorkFolder work_;
    const Mode* mode_ = nullptr;
    std::filesystem::path program_;
    std::optional<std::filesystem::path> program_of_plain_;
    Result result_;
    std::future<HostCode> host_code_;
};

} // namespace

Result run(const Tree& tree, const RunOptions& options) { return Session(tree, options).run(); }

int exit_code(const Result& result) {
    if (result.executions.empty()) return int(ExitCode::bad_usage);
    const bool is_wrong = std::any_of(
        result.findings.begin(), result.findings.end(),
        [](const simt::Finding& finding) { return finding.severity != simt::Severity::note; });
    if (is_wrong) return int(ExitCode::judged_failed);
    const auto any = [&](auto question) {
        return std::any_of(result.executions.begin(), result.executions.end(), question);
    };
    if (!any([](const Execution& e) { return e.summary.has_value(); }))
        return int(ExitCode::tool_failed);
    // A program that says that it failed has not passed, whatever the machine saw.
    return any([](const Execution& e) { return !e.process.succeeded(); })
               ? int(ExitCode::judged_failed)
               : int(ExitCode::success);
}

} // namespace raylab::app
