// From a signal's context to instructions and lines; see interrupted.h.
#include "common/simt/engine/interrupted.h"

#include "common/simt/engine/is_store_aarch64.h"
#include "common/simt/engine/where_is.h"

#include <cstdio>
#include <cstring>
#include <execinfo.h>
#include <sys/ucontext.h>

namespace raylab::simt {

namespace {

struct Registers {
    const void* pc = nullptr;
    const void* returns_to = nullptr; // where a call that led nowhere came from
    bool write = false;
};

Registers registers_of([[maybe_unused]] const ucontext_t& context,
                       [[maybe_unused]] const void* address, [[maybe_unused]] bool of_memory) {
    Registers registers;
#if defined(__x86_64__) && defined(__linux__)
    const auto& values = context.uc_mcontext.gregs;
    registers.pc = reinterpret_cast<const void*>(values[REG_RIP]);
    registers.write = of_memory && values[REG_ERR] & 2;
    if (of_memory && values[REG_ERR] & 16) // it was to be executed: a call pushed its place
        registers.returns_to = *reinterpret_cast<const void* const*>(values[REG_RSP]);
#elif defined(__x86_64__) && defined(__APPLE__)
    registers.pc = reinterpret_cast<const void*>(context.uc_mcontext->__ss.__rip);
    registers.write = of_memory && context.uc_mcontext->__es.__err & 2;
#elif defined(__aarch64__)
#if defined(__APPLE__)
    const auto pc = context.uc_mcontext->__ss.__pc, link = context.uc_mcontext->__ss.__lr;
#else
    const auto pc = context.uc_mcontext.pc, link = context.uc_mcontext.regs[30];
#endif
    registers.pc = reinterpret_cast<const void*>(pc);
    if (of_memory && registers.pc == address) // it was to be executed: a call keeps its place here
        registers.returns_to = reinterpret_cast<const void*>(link);
    else if (of_memory)
        registers.write = is_store_aarch64(*static_cast<const uint32_t*>(registers.pc));
#endif
    return registers;
}

} // namespace

Fault interrupted(int signal, siginfo_t* information, void* context) {
    Fault fault;
    fault.signal = signal;
    fault.code = information->si_code;
    const bool of_memory = signal == SIGSEGV || signal == SIGBUS;
    if (of_memory) fault.address = information->si_addr;
    const Registers registers =
        registers_of(*static_cast<ucontext_t*>(context), information->si_addr, of_memory);
    fault.write = registers.write;
    void* frames[64];
    const int count = backtrace(frames, 64);
    int first = 0; // the frames before are this handler's
    while (first < count && frames[first] != registers.pc) ++first;
    if (first == count || !registers.pc) {
        if (registers.pc) fault.frames[fault.frame_count++] = registers.pc;
        first = registers.pc ? count : 0;
    }
    if (registers.returns_to)
        fault.frames[fault.frame_count++] = static_cast<const char*>(registers.returns_to) - 1;
    for (int i = first; i < count && fault.frame_count < fault.frames.size(); ++i) {
        const auto pc = static_cast<const char*>(frames[i]);
        const bool is_interrupted = pc == registers.pc;
        fault.frames[fault.frame_count++] = is_interrupted ? pc : pc - 1; // else a return address
    }
    return fault;
}

Fault callers_of(const void* pc) {
    Fault fault;
    if (pc) fault.frames[fault.frame_count++] = pc;
    void* frames[40];
    const int count = backtrace(frames, 40);
    for (int i = 0; i < count && fault.frame_count < fault.frames.size(); ++i)
        fault.frames[fault.frame_count++] = static_cast<char*>(frames[i]) - 1;
    return fault;
}

SourcePlace user_place(const Fault& fault) {
    for (size_t i = 0; i < fault.frame_count; ++i)
        if (const auto place = source_place(fault.frames[i])) return *place;
    return {};
}

std::string signal_in_words(const Fault& fault) {
    switch (fault.signal) {
    case SIGFPE:
        return "integer division by zero (or of the smallest integer by -1)";
    case SIGABRT:
        return "abort() was called, perhaps by an exception that nobody caught";
    case SIGILL:
        return "an instruction that the processor does not have";
    default:
        break;
    }
    char text[80];
    const char* what = fault.write ? "written" : "read";
    if (fault.code == 128 && !fault.address) // SI_KERNEL: no address of user memory at all
        return "an address that no memory can have was used";
    if (reinterpret_cast<uintptr_t>(fault.address) < 64 << 10)
        std::snprintf(text, sizeof text, "a null pointer was used: address %p was %s",
                      fault.address, what);
    else
        std::snprintf(text, sizeof text, "address %p was %s, where no memory is", fault.address,
                      what);
    return text;
}

} // namespace raylab::simt
