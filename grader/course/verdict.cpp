#include "grader/course/verdict.h"

#include "common/cli/files.h"
#include "common/cli/process.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <regex>
#include <sstream>
#include <unistd.h>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr double test_limit_seconds = 30; // the labs' own take milliseconds

struct TestOutcome {
    bool passed = false;
    std::vector<std::string> facts;
    std::vector<Stub> stubs;
};

// A name for GoogleTest's report that nobody else has; gone with this object.
class TemporaryFile {
  public:
    TemporaryFile() : path_((fs::temp_directory_path() / "raylab-check-XXXXXX").string()) {
        const int file = mkstemp(path_.data());
        if (file < 0) throw std::system_error(errno, std::generic_category(), path_);
        close(file);
    }
    ~TemporaryFile() { unlink(path_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

// A test program that is not there is nobody's wrong answer.
void expect_started(const ProcessResult& result, const fs::path& program) {
    if (!result.started)
        throw std::runtime_error(fmt::format("'{}' {}", program.string(), why_failed(result)));
}

// The names of the tests that match the filters of a task.
std::vector<std::string> list_tests(const Task& task, const fs::path& program,
                                    const fs::path& folder) {
    std::vector<std::string> names;
    for (const std::string& filter : task.tests) {
        const ProcessResult listing = run_process(
            {program.string(), "--gtest_list_tests", "--gtest_filter=" + filter}, {30, folder});
        expect_started(listing, program);
        std::string suite;
        const std::size_t before = names.size();
        std::istringstream lines(listing.output);
        for (std::string line; std::getline(lines, line);) {
            line = line.substr(0, line.find("  #")); // a parameter's value
            if (line.starts_with("  "))
                names.push_back(suite + line.substr(2));
            else if (line.ends_with("."))
                suite = line;
        }
        if (names.size() == before)
            throw CourseError(fmt::format("task {}: no test of {} matches \"{}\"", task.id,
                                          program.filename().string(), filter));
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
    return failure;
}

std::vector<std::string> facts_in(const std::string& report) {
    std::vector<std::string> facts;
    const auto json = nlohmann::json::parse(report, nullptr, false);
    if (json.is_discarded()) return facts;
    for (const auto& suite : json.at("testsuites"))
        for (const auto& test : suite.at("testsuite"))
            if (test.contains("failures"))
                for (const auto& failure : test.at("failures"))
                    facts.push_back(fact_in(failure.at("failure")));
    return facts;
}

TestOutcome run_test(const std::string& name, const fs::path& program, const fs::path& folder) {
    const TemporaryFile report;
    const ProcessResult process =
        run_process({program.string(), "--gtest_filter=" + name, "--gtest_color=no",
                     "--gtest_output=json:" + report.path()},
                    {test_limit_seconds, folder});
    expect_started(process, program);
    TestOutcome outcome;
    outcome.passed = process.succeeded();
    outcome.stubs = stubs_met(process.output);
    if (outcome.passed) return outcome;
    if (process.timed_out)
        outcome.facts = {fmt::format("{} did not end within {:.0f} s; the likely cause: a loop "
                                     "whose condition never becomes false",
                                     name, test_limit_seconds)};
    else if (process.signal != 0)
        outcome.facts = {fmt::format("{} crashed ({}); the likely cause: an index outside its "
                                     "array, or a recursion that never ends. "
                                     "RAYLAB_PRESET=check ./raylab check names the line",
                                     name, strsignal(process.signal))};
    else
        outcome.facts = facts_in(read_file(report.path()));
    if (outcome.facts.empty())
        outcome.facts = {fmt::format("{} ended with exit code {}", name, process.exit_code)};
    return outcome;
}

template <class T> bool contains(const std::vector<T>& list, const T& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

void append_new(std::vector<Stub>& stubs, const Stub& stub) {
    if (!contains(stubs, stub)) stubs.push_back(stub);
}

} // namespace

std::string Stub::sentence() const {
    return fmt::format("task {} {} is not implemented: {}", task, function, place);
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

TaskResult judge_task(const LabSheet& sheet, const Task& task, const fs::path& program) {
    TaskResult result;
    result.task = task;
    std::vector<Stub> own, needed;
    const auto start = std::chrono::steady_clock::now();
    for (const std::string& name : list_tests(task, program, sheet.root)) {
        const TestOutcome test = run_test(name, program, sheet.root);
        ++result.tests;
        result.passed += test.passed;
        // A test that met a stub it rests on tells nothing that the stub has not told.
        bool tells = true;
        for (const Stub& stub : test.stubs) {
            if (stub.task != task.id && !contains(task.needs, stub.task)) continue;
            tells = false;
            append_new(stub.task == task.id ? own : needed, stub);
        }
        if (tells) result.facts.insert(result.facts.end(), test.facts.begin(), test.facts.end());
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (own.empty() && result.passed < result.tests)
        own = standing_stubs(sheet, sheet.path(), task);

    if (!own.empty())
        result.verdict = Verdict::not_implemented, result.stubs = own;
    else if (result.passed == result.tests)
        result.verdict = Verdict::pass;
    else if (result.facts.empty())
        result.verdict = Verdict::not_implemented, result.stubs = needed;
    else
        result.verdict = Verdict::wrong;
    return result;
}

const char* name(Verdict verdict) {
    switch (verdict) {
    case Verdict::not_implemented:
        return "NOT IMPLEMENTED";
    case Verdict::wrong:
        return "WRONG";
    case Verdict::pass:
        return "PASS";
    }
    return "";
}

} // namespace raylab
