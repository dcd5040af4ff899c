#include "grader/course/verdict.h"

#include "common/cli/files.h"
#include "common/simt/finding.h"
#include "grader/course/contains.h"
#include "grader/course/said.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <iterator>
#include <regex>
#include <sstream>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr double test_limit_seconds = 30; // the labs' own take milliseconds

struct TestOutcome {
    bool passed = false;
    bool launches = false; // kernels of the CPU machine were run
    std::vector<std::string> facts, said;
    std::vector<Stub> stubs;
};

// A test that did not run shows neither a right nor a wrong answer.
[[noreturn]] void did_not_run(const std::string& what, const std::string& why) {
    throw std::runtime_error(
        fmt::format("{} did not run: {}; nothing can be said about the lab", what, why));
}

// The names of the tests that match the filters of a task.
std::vector<std::string> list_tests(const Task& task, const TestProgram& program) {
    std::vector<std::string> names;
    for (const std::string& filter : task.tests) {
        const std::vector<std::string> found = program.tests(filter);
        if (found.empty())
            did_not_run("task " + task.id, fmt::format("no test matches \"{}\"", filter));
        names.insert(names.end(), found.begin(), found.end());
    }
    return names;
}

// ".../labs/02_iterative/path.h:41" -> "labs/02_iterative/path.h:41", wherever the lab was copied.
std::string in_lab(const std::string& place) {
    const std::size_t at = place.rfind("labs/");
    return at == place.npos ? place : place.substr(at);
}

std::vector<Stub> stubs_met(const std::string& output) {
    static const std::regex said(R"(task ([0-9.]+) (.+) is not implemented: ([^\n:]+:[0-9]+))");
    std::vector<Stub> stubs;
    for (std::sregex_iterator match(output.begin(), output.end(), said), end; match != end; ++match)
        stubs.push_back({(*match)[1], (*match)[2], in_lab((*match)[3])});
    return stubs;
}

// GoogleTest's failure begins with "file:line\nFailed\n"; what follows is for the student.
std::string fact_in(std::string failure) {
    if (const std::size_t line = failure.find('\n'); line != failure.npos)
        failure.erase(0, line + 1);
    if (failure.starts_with("Failed\n")) failure.erase(0, std::strlen("Failed\n"));
    while (failure.ends_with('\n')) failure.pop_back();
    static const std::regex thrown(R"re(C\+\+ exception with description "([^]*)" thrown in .*)re");
    return std::regex_replace(failure, thrown, "the test was ended by an error: $1");
}

// After a crash of a test of the lab with this number.
std::string crash_fact(const std::string& name, int signal, const std::string& lab) {
    if (signal == SIGFPE)
        return fmt::format("{} crashed ({}); the likely cause: a whole number is divided by zero",
                           name, strsignal(signal));
    return fmt::format("{} crashed ({}); the likely cause: an index outside its array, or a "
                       "recursion that never ends. RAYLAB_PRESET=check ./raylab check {} names the "
                       "line",
                       name, strsignal(signal), lab);
}

// What GoogleTest's report says about its one test.
struct Report {
    bool completed = false; // it ran to its end
    std::string result;     // if it did not: "SKIPPED", or "SUPPRESSED" if disabled
    std::vector<std::string> failures;
};

// A report of a submission's program may be anything.
Report read_report(const std::string& text) try {
    Report report;
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded()) return report;
    for (const auto& suite : json.at("testsuites"))
        for (const auto& test : suite.at("testsuite")) {
            report.result = test.at("result");
            report.completed = report.result == "COMPLETED";
            if (test.contains("failures"))
                for (const auto& failure : test.at("failures"))
                    report.failures.push_back(failure.at("failure"));
        }
    return report;
} catch (const nlohmann::json::exception&) {
    return {};
}

// What the machine that watches every access (common/simt/watch) has found wrong, a sentence each.
std::vector<std::string> watched_mistakes(const std::vector<simt::Finding>& findings) {
    std::vector<std::string> sentences;
    for (const simt::Finding& finding : simt::folded(findings)) {
        if (finding.mode != "watch" || finding.severity != simt::Severity::error) continue;
        std::string sentence = fmt::format("{}:{}: {}; {}", finding.place.file, finding.place.line,
                                           finding.message, finding.advice);
        if (finding.other)
            sentence += fmt::format(" (the other end: {}:{})", finding.other->place.file,
                                    finding.other->place.line);
        sentences.push_back(sentence);
    }
    return sentences;
}

// Throws if the test did not run through no fault of the lab. An untrusted program cannot excuse
// itself so: the same tests run with the stubs.
void expect_run(const std::string& name, const TestRun& run, const Report& report) {
    if (!report.completed && !report.result.empty())
        did_not_run(name, "it was skipped or disabled");
    // After its first line a test calls the lab's functions, so an early end is the lab's mistake.
    if (!run.began) did_not_run(name, why_failed(run.process));
    // These are the words of common/simt/check.h.
    if (run.process.output.find("no NVIDIA GPU or driver was found") != std::string::npos)
        did_not_run(name, "no NVIDIA GPU or driver was found on this machine; RAYLAB_PRESET=cpu "
                          "checks on the CPU machine");
    if (!run.process.timed_out && run.process.signal == 0 && !report.completed &&
        run.process.output.find("] " + name + " (") != std::string::npos)
        did_not_run(name, "it ended, but its report could not be written: is the disk full?");
}

TestOutcome run_test_once(const std::string& name, const std::string& order,
                          const TestProgram& program, const LabSheet& sheet, double limit_seconds) {
    const TestRun run = program.run(name, order, limit_seconds);
    const ProcessResult& process = run.process;
    const Report report = read_report(run.report);
    if (program.trusted()) expect_run(name, run, report);
    TestOutcome outcome;
    outcome.passed = process.succeeded() && report.completed && program.passed();
    outcome.stubs = stubs_met(process.output);
    outcome.said = said_by_test(process.output, name, report.failures);
    const simt::FindingsFile found = simt::parse_findings(run.findings);
    outcome.launches = found.summary && found.summary->launches > 0;
    const std::vector<std::string> mistakes = watched_mistakes(found.findings);
    if (outcome.passed && mistakes.empty()) return outcome;
    if (!process.started)
        outcome.facts = {fmt::format("{} was not run, since one before it did not end", name)};
    else if (process.timed_out)
        outcome.facts = {fmt::format("{} did not end within {:.0f} s; the likely cause: a loop "
                                     "whose condition never becomes false",
                                     name, limit_seconds)};
    else if (process.signal != 0)
        outcome.facts = {crash_fact(name, process.signal, sheet.number)};
    else if (!report.completed)
        outcome.facts = {fmt::format("{} ended the program with exit code {} before the test was "
                                     "over; the likely cause: a call of exit()",
                                     name, process.exit_code)};
    else
        std::transform(report.failures.begin(), report.failures.end(),
                       std::back_inserter(outcome.facts), fact_in);
    outcome.passed = false;
    outcome.facts.insert(outcome.facts.end(), mistakes.begin(), mistakes.end());
    if (outcome.facts.empty())
        outcome.facts = {fmt::format("{} ended with exit code {}", name, process.exit_code)};
    return outcome;
}

// A kernel gives one result, whichever of its threads comes first. So a test that passes runs again
// with the threads in reverse order; one without a kernel does not.
TestOutcome run_test(const std::string& name, const TestProgram& program, const LabSheet& sheet,
                     double limit_seconds) {
    const TestOutcome forward = run_test_once(name, "forward", program, sheet, limit_seconds);
    if (!forward.passed || !forward.launches) return forward;
    TestOutcome reverse = run_test_once(name, "reverse", program, sheet, limit_seconds);
    for (std::string& fact : reverse.facts)
        fact = "where the CUDA threads run in reverse order, which must change nothing: " + fact;
    return reverse;
}

template <class T> void append_new(std::vector<T>& list, const T& value) {
    if (!contains(list, value)) list.push_back(value);
}

} // namespace

std::string Stub::sentence() const {
    return fmt::format("task {} {} is not implemented: {}", task, function, place);
}

std::string TaskResult::before(const Stub& stub) const {
    if (stub.task == task.id) return "";
    return verdict == TaskVerdict::waits ? fmt::format("written, waits for {}: ", stub.task)
                                         : "needs first: ";
}

std::vector<Stub> standing_stubs(const LabSheet& sheet, const fs::path& lab_folder,
                                 const Task& task) {
    static const std::regex call(R"re(^\s*not_implemented\("([0-9.]+)", "([^"]+)"\))re");
    std::vector<Stub> stubs;
    for (const std::string& file : task.files) {
        std::istringstream lines(read_file((lab_folder / file).string()));
        std::smatch match;
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            if (std::regex_search(line, match, call) && match[1] == task.id)
                stubs.push_back(
                    {task.id, match[2], fmt::format("labs/{}/{}:{}", sheet.folder, file, number)});
        }
    }
    return stubs;
}

TaskResult judge_task(const LabSheet& sheet, const Task& task, const fs::path& program,
                      double patience) {
    return judge_task(sheet, task, OwnTestProgram(program, sheet.root), patience);
}

TaskResult judge_task(const LabSheet& sheet, const Task& task, const TestProgram& program,
                      double patience) {
    TaskResult result;
    result.task = task;
    std::vector<Stub> own, needed;
    const auto start = std::chrono::steady_clock::now();
    for (const std::string& name : list_tests(task, program)) {
        const TestOutcome test = run_test(name, program, sheet, patience * test_limit_seconds);
        ++result.tests;
        result.passed += test.passed;
        // A test that met a stub that it needs shows nothing more than this stub.
        bool tells = true;
        for (const Stub& stub : test.stubs) {
            if (stub.task != task.id && !contains(task.needs, stub.task)) continue;
            tells = false;
            append_new(stub.task == task.id ? own : needed, stub);
        }
        for (const std::string& line : test.said) append_new(result.said, line);
        if (!tells) continue;
        for (const std::string& fact : test.facts) append_new(result.facts, fact);
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (own.empty() && result.passed < result.tests)
        own = standing_stubs(sheet, sheet.path(), task);

    if (!own.empty())
        result.verdict = TaskVerdict::not_implemented, result.stubs = own;
    else if (result.passed == result.tests)
        result.verdict = TaskVerdict::pass;
    else if (result.facts.empty())
        result.verdict = TaskVerdict::waits, result.stubs = needed;
    else
        result.verdict = TaskVerdict::wrong;
    return result;
}

const char* name(TaskVerdict verdict) {
    switch (verdict) {
    case TaskVerdict::not_implemented:
        return "NOT IMPLEMENTED";
    case TaskVerdict::waits:
        return "WAITS";
    case TaskVerdict::wrong:
        return "WRONG";
    case TaskVerdict::pass:
        return "PASS";
    }
    return "";
}

} // namespace raylab
