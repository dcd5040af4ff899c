// Reports of what the processor refused, of failed assertions, and of kernels that do not end.
#include "common/simt/engine/interrupted.h"
#include "common/simt/engine/memory.h"
#include "common/simt/engine/report.h"
#include "common/simt/engine/where_is.h"

#include <csignal>
#include <cstdint>
#include <cstdio>

namespace raylab::simt {

namespace {

constexpr uintptr_t null_bytes = 64 << 10; // a null pointer, and an index or a member behind it

std::string in_hexadecimal(const void* address) {
    char text[24];
    std::snprintf(text, sizeof text, "0x%llx", (unsigned long long)(uintptr_t(address)));
    return text;
}

std::string to_do(const std::string& advice) { return "  to do: " + advice; }

} // namespace

// The statement, else the launch and in which function it was.
std::string Report::head(const Fault& fault, const std::string& what) const {
    const Launch& launch = block_.work_->launch;
    const SourcePlace at = user_place(fault);
    std::string function, where = place(launch.file, launch.line);
    if (at.line > 0)
        where = place(at.file.c_str(), at.line) +
                (at.column > 0 ? ":" + std::to_string(at.column) : "");
    else if (fault.frame_count > 0)
        function = function_name(fault.frames[0]);
    return head(where, function.empty() ? what : what + ", in " + function, block_.running_);
}

std::string Report::overwritten(const void* pc) const {
    Fault fault;
    fault.frames[fault.frame_count++] = pc ? pc : block_.work_->launch.function;
    return head(fault, "overrun of a local array: this function has overwritten its own stack") +
           to_do("check the indices of the arrays that are local to it");
}

std::string Report::bad_address(const Fault& fault) const {
    // In the engine, right after a kernel: what the kernel left of its stack is of no use.
    if (user_place(fault).line == 0 && fault.frame_count > 0 &&
        function_name(fault.frames[0]).starts_with("raylab::simt::Block::"))
        return overwritten(nullptr);
    const std::string did = fault.write ? " is written" : " is read";
    const std::string address = in_hexadecimal(fault.address);
    if (block_.is_stack_overflow(fault.address))
        return head(fault, "stack overflow: the thread's stack of " +
                               std::to_string(block_.options_.stack_size) + " bytes is full") +
               to_do("end the recursion, or make local arrays smaller: a GPU's thread has about "
                     "1 KiB of stack");
    if (block_.shared_.is_overrun(fault.address)) {
        const auto start = static_cast<const char*>(block_.shared_.data());
        return head(fault, "overrun of dynamic shared memory: byte " +
                               std::to_string(static_cast<const char*>(fault.address) - start) +
                               " of " + std::to_string(block_.shared_.bytes()) + did) +
               to_do("give the launch the bytes that the kernel uses, count * sizeof(type), as its "
                     "third parameter: k<<<grid, block, bytes>>>");
    }
    if (fault.code == 128 && !fault.address) // Linux does not tell it
        return head(fault, "wild address: the kernel uses an address that no memory can have") +
               to_do("give the pointer a value before it is used, and check what cudaMalloc() "
                     "returned");
    if (uintptr_t(fault.address) < null_bytes)
        return head(fault, "null pointer: address " + address + did) +
               to_do("allocate the memory with cudaMalloc(), check what it returned, and give the "
                     "kernel that pointer");
    return head(fault, "wild address: " + address + did + ", " + describe_address(fault.address)) +
           to_do("check the index, also for overflow of int, and that the pointer was set");
}

std::string Report::crashed(const Fault& fault) const {
    switch (fault.signal) {
    case SIGFPE:
        return head(fault, "division by zero: an integer is divided by 0, or the smallest one by "
                           "-1") +
               to_do("test the divisor first; a GPU gives a meaningless number instead");
    case SIGABRT:
        return head(fault, "abort() was called in the kernel") +
               to_do("look for an exception that nobody catches, which a GPU does not know");
    case SIGILL:
        return head(fault, "an instruction that does not exist was reached") +
               to_do("look for a function that returns no value, or a __builtin_trap()");
    default:
        return bad_address(fault);
    }
}

std::string Report::failed_assertion(const char* condition, const char* file, int line) const {
    return head(place(file, line), std::string("assertion failed: ") + condition, block_.running_) +
           to_do("look at the values of this thread that the condition compares");
}

std::string Report::still_running(const Fault& fault, double seconds) const {
    int elsewhere = 0;
    for (int thread = 0; thread < block_.count_; ++thread)
        elsewhere += thread != block_.running_ && block_.status_[thread] != Block::Status::ended;
    char time[32];
    std::snprintf(time, sizeof time, "%.0f s", seconds);
    std::string text =
        head(fault, "the kernel does not end: after " + std::string(time) + " it is still here");
    if (elsewhere > 0)
        text += "  " + std::to_string(elsewhere) +
                " other threads of the block have not returned, "
                "and get no turn before this one waits at a barrier or returns\n";
    return text + to_do("end the loop; if it waits for another thread or block to write, know that "
                        "a GPU need not run that one either; if it is only slow, use fewer threads "
                        "or a longer --time-limit");
}

} // namespace raylab::simt
