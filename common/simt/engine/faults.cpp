// The handlers of signals; see faults.h.
//
// In an ordinary build the handler leaves the kernel as every fault does: it switches to the
// worker, which writes the report, and the launch has failed as on a GPU. Under a sanitizer the
// program ends with its first error, so there the report is written at once.
#include "common/simt/engine/faults.h"

#include "common/simt/engine/block.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/interrupted.h"
#include "common/simt/engine/report.h"
#include "common/simt/engine/where_is.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <sys/mman.h>
#include <unistd.h>

namespace raylab::simt {

namespace {

constexpr int caught[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

struct sigaction before[64]; // by signal: who had it, a sanitizer for instance

// As if this program had no handler: who had the signal before gets it.
void pass_on(int signal, siginfo_t* information, void* context) {
    const struct sigaction& old = before[signal];
    if (old.sa_flags & SA_SIGINFO && old.sa_sigaction)
        return old.sa_sigaction(signal, information, context);
    if (old.sa_handler != SIG_DFL && old.sa_handler != SIG_IGN) return old.sa_handler(signal);
    sigaction(signal, &old, nullptr);
    // The instruction is tried again, and fails again; what was sent must be sent again.
    if (information->si_code <= 0) raise(signal);
}

// Host code is about to end with a signal.
void record_crash_of_host(const Fault& fault) {
    if (!records_findings()) return;
    Finding finding;
    finding.kind = "host-crash";
    finding.place = user_place(fault);
    finding.message = "the program's host code was ended by a signal: " + signal_in_words(fault);
    finding.advice = "look at this statement, and at the pointers and indices that it uses";
    record(std::move(finding));
    write_summary();
}

void handle(int signal, siginfo_t* information, void* context) {
    const Fault fault = interrupted(signal, information, context);
    if (Block* block = current_block) {
        sigset_t mask; // whoever leaves a handler by another way must let the signal in again
        sigemptyset(&mask);
        sigaddset(&mask, signal);
        pthread_sigmask(SIG_UNBLOCK, &mask, nullptr);
        block->crash(fault);
    }
    static bool crashing = false;
    if (!std::exchange(crashing, true)) record_crash_of_host(fault);
    pass_on(signal, information, context);
}

void install_handlers() {
    struct sigaction action {};
    action.sa_sigaction = handle;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    for (int signal : caught) sigaction(signal, &action, &before[signal]);
}

// A stack for the calling thread's handlers, as long as the thread lives.
class AlternateStack {
  public:
    AlternateStack() {
        memory_ = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory_ == MAP_FAILED) return;
        stack_t stack{};
        stack.ss_sp = memory_;
        stack.ss_size = bytes;
        is_set_ = sigaltstack(&stack, &before_) == 0;
    }
    ~AlternateStack() {
        if (is_set_) sigaltstack(&before_, nullptr);
        if (memory_ != MAP_FAILED) munmap(memory_, bytes);
    }
    AlternateStack(const AlternateStack&) = delete;
    AlternateStack& operator=(const AlternateStack&) = delete;

  private:
    static constexpr size_t bytes = size_t(256) << 10; // enough to read debug information on
    void* memory_ = MAP_FAILED;
    stack_t before_{};
    bool is_set_ = false;
};

} // namespace

void expect_faults() {
    static std::once_flag once;
    std::call_once(once, install_handlers);
    thread_local AlternateStack stack;
    (void)stack;
}

} // namespace raylab::simt

#if defined(__GLIBC__)

// What assert() calls: within a kernel it is the CUDA thread that fails, elsewhere all is as usual.
extern "C" [[noreturn]] void __assert_fail(const char* condition, const char* file, unsigned line,
                                           const char* function) noexcept {
    using namespace raylab::simt;
    if (Block* block = current_block) block->fail_assertion(condition, file, int(line));
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s:%u: %s: Assertion `%s' failed.\n", program_invocation_short_name,
                 file, line, function, condition);
    std::abort();
}

// What a function calls at its end, if it was compiled with -fstack-protector and its frame was
// overwritten.
extern "C" [[noreturn]] void __stack_chk_fail() {
    using namespace raylab::simt;
    if (Block* block = current_block)
        block->overwrite(static_cast<const char*>(__builtin_return_address(0)) - 1);
    std::fputs("*** stack smashing detected ***: terminated\n", stderr);
    std::abort();
}

#endif
