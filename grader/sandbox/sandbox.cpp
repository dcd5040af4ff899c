#include "grader/sandbox/sandbox.h"

#include "grader/sandbox/bubblewrap.h"
#include "grader/sandbox/capture.h"
#include "grader/sandbox/cgroup.h"
#include "grader/sandbox/child.h"
#include "grader/sandbox/descriptors.h"
#include "grader/sandbox/landlock.h"
#include "grader/sandbox/leftovers.h"
#include "grader/sandbox/seccomp_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace raylab::sandbox {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int filter_handle = 10, status_handle = 11; // of bubblewrap

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> all;
    for (std::string& word : words) all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

std::vector<std::filesystem::path> places(const std::vector<Bind>& binds) {
    std::vector<std::filesystem::path> all;
    for (const Bind& bind : binds) {
        if (bind.from != bind.to)
            throw std::invalid_argument("this tier shows files only where they are");
        all.push_back(bind.to);
    }
    return all;
}

// One run: what is prepared for it, and what is seen of it.
class Run {
  public:
    Run(const std::vector<std::string>& command, const SandboxOptions& options,
        const Isolation& isolation)
        : options_(options), isolation_(isolation), command_(command),
          group_(isolation.memory ? options.limits.memory : 0,
                 isolation.pids ? options.limits.processes : 0) {
        capture_ = Capture(options.whole_output);
        prepare();
    }
    ~Run() {
        if (plan_.landlock >= 0) close(plan_.landlock);
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    Outcome operator()();

  private:
    void prepare();
    void watch();
    void end_all();
    void conclude(Outcome& outcome);

    const SandboxOptions& options_;
    const Isolation& isolation_;
    std::vector<std::string> command_, environment_;
    Cgroup group_;
    Pipe go_, trouble_, output_, status_; // status_: bubblewrap's
    Handle input_{open("/dev/null", O_RDONLY | O_CLOEXEC)}, filter_file_;
    std::string filter_;
    std::vector<std::unique_ptr<Handle>> given_;
    ChildPlan plan_;
    Capture capture_;
    pid_t child_ = -1;
    int wait_status_ = 0;
    bool ended_ = false, too_long_ = false, too_much_ = false;
    rusage usage_ = {};
    Clock::time_point start_ = Clock::now();
};

void Run::prepare() {
    const Limits& limits = options_.limits;
    environment_ = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "HOME=/tmp"};
    for (const auto& [name, value] : options_.environment)
        environment_.push_back(name + "=" + value);
    for (const auto& [number, handle] : options_.handles) {
        if (number < 3 || number > 9)
            throw std::invalid_argument("handles have numbers from 3 to 9");
        given_.push_back(std::make_unique<Handle>(high_handle(handle)));
        plan_.handles.push_back({given_.back()->get(), number});
    }
    filter_ = isolation_.tier == Tier::limited ? "" : seccomp_filter();
    if (isolation_.tier == Tier::isolated) {
        filter_file_.reset(memfd_create("filter", MFD_CLOEXEC));
        if (write(filter_file_.get(), filter_.data(), filter_.size()) < 0 ||
            lseek(filter_file_.get(), 0, SEEK_SET) != 0)
            throw std::system_error(errno, std::generic_category(), "memfd");
        given_.push_back(std::make_unique<Handle>(high_handle(filter_file_.get())));
        plan_.handles.push_back({given_.back()->get(), filter_handle});
        plan_.handles.push_back({status_.write.get(), status_handle});
        SandboxOptions inside = options_;
        for (const std::string variable : {"PATH", "LANG", "HOME"})
            inside.environment.emplace(variable, variable == "PATH"   ? "/usr/bin:/bin"
                                                 : variable == "LANG" ? "C.UTF-8"
                                                                      : "/tmp");
        command_ = in_bubblewrap(command_, inside, filter_handle, status_handle);
    } else {
        std::vector<std::filesystem::path> readable = places(options_.readable);
        const std::vector<std::filesystem::path> writable = places(options_.writable);
        for (const auto& folder : system_folders()) readable.push_back(folder);
        if (isolation_.tier == Tier::confined) {
            plan_.landlock = landlock_rules(readable, writable);
            plan_.filter = {static_cast<unsigned short>(filter_.size() / sizeof(sock_filter)),
                            reinterpret_cast<sock_filter*>(filter_.data())};
        }
        plan_.folder = options_.folder.c_str();
    }
    plan_.arguments = pointers(command_);
    plan_.environment = pointers(environment_);
    plan_.go = go_.read.get();
    plan_.status = trouble_.write.get();
    plan_.input = input_.get();
    plan_.output = output_.write.get();
    plan_.user = isolation_.own_user ? sandbox_user() : 0;
    plan_.cpu_seconds = static_cast<std::uint64_t>(std::ceil(limits.cpu_seconds));
    plan_.file_size = limits.file_size;
    // Counted for a user id: of use only if nobody else has it. bubblewrap takes two for itself.
    plan_.processes = isolation_.own_user ? static_cast<std::uint64_t>(limits.processes) + 2 : 0;
    // Each process alone, where no group counts them together.
    plan_.data = isolation_.memory ? 0 : limits.memory;
}

// Reads what is printed until the program has ended, the time is over or it has printed too much.
void Run::watch() {
    const auto deadline = start_ + std::chrono::duration<double>(options_.limits.wall_seconds);
    bool open = true;
    while (!ended_) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) {
            too_long_ = true;
            return;
        }
        pollfd waiting = {open ? output_.read.get() : -1, POLLIN, 0};
        poll(&waiting, 1, open ? static_cast<int>(std::min<long long>(left, 20)) : 1);
        if (open && waiting.revents != 0) {
            char buffer[65536];
            const ssize_t n = read(output_.read.get(), buffer, sizeof buffer);
            if (n > 0) capture_.add({buffer, static_cast<std::size_t>(n)});
            if (n == 0) open = false;
            if (capture_.total() > options_.limits.output) {
                too_much_ = true;
                return;
            }
        }
        ended_ = wait4(child_, &wait_status_, WNOHANG, &usage_) == child_;
    }
}

void Run::end_all() {
    if (!ended_) {
        kill(-child_, SIGKILL); // its session, where setsid() was done
        kill(child_, SIGKILL);
    }
    group_.kill_all();
    if (isolation_.own_user) kill_user(sandbox_user());
    while (!ended_) {
        const pid_t got = wait4(child_, &wait_status_, 0, &usage_);
        ended_ = got == child_ || (got < 0 && errno != EINTR);
    }
    reap_orphans(child_);
    // A process that left the session in tier 3 may hold the pipe: what is there is read, no more.
    fcntl(output_.read.get(), F_SETFL, O_NONBLOCK);
    capture_.add(all_of(output_.read.get()));
}

void Run::conclude(Outcome& outcome) {
    outcome.output = capture_.text();
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    outcome.cpu_seconds = seconds(usage_.ru_utime) + seconds(usage_.ru_stime);
    outcome.peak_memory = group_.peak_memory();
    trouble_.write.reset();
    if (const std::string said = all_of(trouble_.read.get()); said.size() == sizeof(ChildTrouble)) {
        ChildTrouble trouble;
        std::memcpy(&trouble, said.data(), sizeof trouble);
        outcome.trouble = fmt::format("{}: {}", trouble.step, std::strerror(trouble.error));
        return;
    }
    if (WIFEXITED(wait_status_)) outcome.exit_code = WEXITSTATUS(wait_status_);
    if (WIFSIGNALED(wait_status_)) outcome.signal = WTERMSIG(wait_status_);
    if (isolation_.tier == Tier::isolated) {
        status_.write.reset();
        // bubblewrap says how the command ended only if it could be started.
        const bool began = all_of(status_.read.get()).find("\"exit-code\"") != std::string::npos;
        if (!began && !too_long_ && !too_much_ && !group_.out_of_memory()) {
            outcome.trouble =
                outcome.output.empty() ? "bubblewrap ended without a word" : outcome.output;
            return;
        }
        if (outcome.exit_code > 128) outcome.signal = outcome.exit_code - 128; // as a shell does
    }
    if (outcome.signal != 0) outcome.exit_code = -1;
    if (too_much_ || outcome.signal == SIGXFSZ)
        outcome.end = End::output_limit;
    else if (group_.out_of_memory())
        outcome.end = End::memory_limit;
    else if (too_long_ || outcome.signal == SIGXCPU ||
             (outcome.signal == SIGKILL && outcome.cpu_seconds > options_.limits.cpu_seconds))
        outcome.end = End::time_limit;
    else if (group_.out_of_pids() && outcome.exit_code != 0)
        outcome.end = End::process_limit;
    else
        outcome.end = outcome.signal != 0 ? End::crashed : End::exited;
}

Outcome Run::operator()() {
    Outcome outcome;
    outcome.tier = isolation_.tier;
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    child_ = fork();
    if (child_ == 0) become(plan_);
    if (child_ < 0) {
        outcome.trouble = fmt::format("fork: {}", std::strerror(errno));
        return outcome;
    }
    group_.add(child_);
    for (Handle* ours : {&output_.write, &trouble_.write, &status_.write}) ours->reset();
    [[maybe_unused]] const ssize_t written = write(go_.write.get(), "!", 1);
    watch();
    end_all();
    outcome.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    conclude(outcome);
    return outcome;
}

} // namespace

Outcome run(const std::vector<std::string>& command, const SandboxOptions& options,
            const Isolation& isolation) {
    if (command.empty() || !command[0].starts_with('/'))
        throw std::invalid_argument("a sandbox runs programs by their absolute path");
    try {
        return Run(command, options, isolation)();
    } catch (const std::system_error& error) {
        Outcome outcome;
        outcome.trouble = error.what();
        outcome.tier = isolation.tier;
        return outcome;
    }
}

} // namespace raylab::sandbox
