#include "grader/grading/test_runs.h"

#include "grader/grading/secret.h"
#include "grader/sandbox/work_folder.h"

#include <fcntl.h>
#include <unistd.h>

namespace raylab::grading {

namespace {

constexpr std::uint64_t report_bytes = 1 << 20;

// A pipe of the witness; both ends are closed at the end.
struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
    }
    ~Pipe() { close_end(0), close_end(1); }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(int end) {
        if (ends[end] >= 0) close(ends[end]);
        ends[end] = -1;
    }
};

std::string read_all(int handle) {
    std::string text(1 << 16, '\0');
    fcntl(handle, F_SETFL, O_NONBLOCK);
    const ssize_t n = read(handle, text.data(), text.size());
    text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    return text;
}

ProcessResult as_process(const sandbox::Outcome& outcome) {
    ProcessResult result;
    result.started = true;
    result.exit_code = outcome.exit_code;
    result.signal = outcome.end == sandbox::End::crashed ? outcome.signal : 0;
    result.timed_out = outcome.end == sandbox::End::time_limit;
    result.seconds = outcome.seconds;
    result.output = outcome.output;
    return result;
}

} // namespace

TestRun SubmittedTests::run(const std::string& name, const std::string& order,
                            double limit_seconds) const {
    passed_ = false;
    if (bad_end_ == sandbox::End::time_limit) return {};
    const std::string nonce = random_hex(16); // 32 digits, as the witness expects
    Pipe question, answer;
    if (write(question.ends[1], nonce.data(), nonce.size()) != static_cast<ssize_t>(nonce.size()))
        throw std::system_error(errno, std::generic_category(), "pipe");
    question.close_end(1);
    const sandbox::WorkFolder out(isolation_, 4 << 20, 32);
    sandbox::SandboxOptions options;
    options.readable = {program_};
    options.writable = {out.path()};
    options.environment = {{"RAYLAB_ORDER", order}, {"RAYLAB_FINDINGS", out.path() / "findings"}};
    options.handles = {{3, question.ends[0]}, {4, answer.ends[1]}};
    options.limits = {.wall_seconds = 3 * limit_seconds, // others may keep the machine busy
                      .cpu_seconds = limit_seconds,
                      .memory = 2ull << 30,
                      .file_size = 4 << 20};
    const sandbox::Outcome outcome =
        sandbox::run({program_, "--gtest_filter=" + name, "--gtest_color=no",
                      "--gtest_output=json:" + (out.path() / "report.json").string()},
                     options, isolation_);
    if (outcome.end == sandbox::End::not_started)
        throw std::runtime_error("a test could not be started in the sandbox: " + outcome.trouble);
    answer.close_end(1);
    const std::string expected = nonce + "\n" + name + " passed\nend\n";
    passed_ = outcome.succeeded() && read_all(answer.ends[0]) == expected;

    TestRun test;
    test.process = as_process(outcome);
    test.began = true;
    test.report = sandbox::read_output(out.path(), "report.json", report_bytes).bytes;
    test.findings = sandbox::read_output(out.path(), "findings", report_bytes).bytes;
    if (outcome.end != sandbox::End::exited) bad_end_ = outcome.end;
    if (outcome.succeeded() && !passed_) forged_ = true;
    return test;
}

} // namespace raylab::grading
