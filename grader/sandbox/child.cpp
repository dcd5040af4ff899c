#include "grader/sandbox/child.h"

#include "grader/sandbox/landlock.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <grp.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace raylab::sandbox {

namespace {

constexpr int first_unused = 12; // numbers below may be handles of the program or bubblewrap

[[noreturn]] void fail(const ChildPlan& plan, const char* step) {
    ChildTrouble trouble = {{}, errno};
    std::strncpy(trouble.step, step, sizeof trouble.step - 1);
    [[maybe_unused]] const ssize_t written = write(plan.status, &trouble, sizeof trouble);
    _exit(127);
}

void limit(const ChildPlan& plan, decltype(RLIMIT_CPU) resource, std::uint64_t value,
           std::uint64_t more = 0) {
    const rlimit both = {value, value + more};
    if (setrlimit(resource, &both) != 0) fail(plan, "setrlimit");
}

// Descriptors that the grader has open must not reach the program: marked all, but for those it
// gets.
void close_others(const ChildPlan& plan) {
    for (int number = 3; number < first_unused; ++number) {
        bool given = false;
        for (const HandleMove& move : plan.handles) given = given || move.to == number;
        if (!given) fcntl(number, F_SETFD, FD_CLOEXEC);
    }
    constexpr unsigned close_on_exec = 4; // CLOSE_RANGE_CLOEXEC
#ifdef SYS_close_range
    if (syscall(SYS_close_range, unsigned(first_unused), ~0u, close_on_exec) == 0) return;
#endif
    for (int number = first_unused; number < 4096; ++number) fcntl(number, F_SETFD, FD_CLOEXEC);
}

} // namespace

void become(const ChildPlan& plan) {
    char byte;
    while (read(plan.go, &byte, 1) < 0 && errno == EINTR) {
    }
    setsid();
    for (int signal = 1; signal < NSIG; ++signal)
        std::signal(signal, SIG_DFL); // an ignored signal stays ignored over exec()
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    if (dup2(plan.input, 0) < 0 || dup2(plan.output, 1) < 0 || dup2(plan.output, 2) < 0)
        fail(plan, "dup2");
    for (const HandleMove& move : plan.handles)
        if (dup2(move.from, move.to) < 0) fail(plan, "dup2");

    // The soft limit of the processor's time sends SIGXCPU, the hard one SIGKILL.
    if (plan.cpu_seconds > 0) limit(plan, RLIMIT_CPU, plan.cpu_seconds, 1);
    if (plan.file_size > 0) limit(plan, RLIMIT_FSIZE, plan.file_size);
    if (plan.data > 0) limit(plan, RLIMIT_DATA, plan.data);
    if (plan.processes > 0) limit(plan, RLIMIT_NPROC, plan.processes);
    limit(plan, RLIMIT_CORE, 0);
    limit(plan, RLIMIT_NOFILE, 256);

    if (plan.user != 0 &&
        (setgroups(0, nullptr) != 0 || setresgid(plan.user, plan.user, plan.user) != 0 ||
         setresuid(plan.user, plan.user, plan.user) != 0))
        fail(plan, "setresuid");
    // After the change of user, which takes it back: the program dies with the grader.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (plan.folder != nullptr && chdir(plan.folder) != 0) fail(plan, "chdir");
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail(plan, "PR_SET_NO_NEW_PRIVS");
    close_others(plan);
    if (plan.landlock >= 0 && !landlock_restrict_self(plan.landlock)) fail(plan, "landlock");
    if (plan.filter.len > 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &plan.filter) != 0)
        fail(plan, "seccomp");
    execve(plan.arguments[0], plan.arguments.data(), plan.environment.data());
    fail(plan, "exec");
}

} // namespace raylab::sandbox
