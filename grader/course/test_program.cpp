#include "grader/course/test_program.h"

#include "common/cli/files.h"

#include <fmt/format.h>

#include <sstream>
#include <unistd.h>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr double patience_with_the_machine = 10; // so many limits, while others keep it busy

// A file name for GoogleTest's report that nobody else uses. The destructor removes the file.
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

} // namespace

std::vector<std::string> OwnTestProgram::tests(const std::string& filter) const {
    const ProcessResult listing = run_process(
        {program_.string(), "--gtest_list_tests", "--gtest_filter=" + filter}, {30, folder_});
    if (!listing.succeeded())
        throw std::runtime_error(
            fmt::format("'{}' did not run: {}; nothing can be said about the lab",
                        program_.string(), why_failed(listing)));
    std::vector<std::string> names;
    std::string suite;
    std::istringstream lines(listing.output);
    for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find("  #")); // a parameter's value
        if (line.starts_with("  "))
            names.push_back(suite + line.substr(2));
        else if (line.ends_with("."))
            suite = line;
    }
    return names;
}

TestRun OwnTestProgram::run(const std::string& name, const std::string& order,
                            double limit_seconds) const {
    const TemporaryFile file, findings;
    TestRun test;
    // Looked for as output comes, since only the end of long output is kept.
    test.process = run_process(
        {"env", "RAYLAB_FINDINGS=" + findings.path(), "RAYLAB_ORDER=" + order, program_.string(),
         "--gtest_filter=" + name, "--gtest_color=no", "--gtest_output=json:" + file.path()},
        {.limit_seconds = limit_seconds,
         .folder = folder_,
         .watch =
             [&](const std::string& output) {
                 test.began = test.began || output.find("[ RUN      ] " + name) != output.npos;
             },
         .limit_on_a_busy_machine = patience_with_the_machine * limit_seconds});
    test.report = read_file(file.path());
    test.findings = read_file(findings.path());
    return test;
}

} // namespace raylab
