// Findings about host code, and about memory that is some thread's own.
#include "common/simt/engine/memory.h"
#include "common/simt/watch/say.h"
#include "common/simt/watch/say_text.h"
#include "common/simt/watch/watcher.h"

#include <algorithm>

namespace raylab::simt::watch {

void say_host_access(uintptr_t address, bool writes, Pc pc) {
    const Target target = look_up(reinterpret_cast<const void*>(address));
    if (target.known && target.kind != MemoryKind::device) return; // pinned, managed
    Finding finding;
    finding.kind = "host-reads-device";
    finding.place = place_of(pc);
    finding.mode = "watch";
    finding.message = std::string("host code ") + (writes ? "writes" : "reads") + " device memory" +
                      (target.known ? ", " + describe(target) : "");
    finding.advice = "copy it to host memory with cudaMemcpy() first";
    emit(finding);
}

void say_host_variable(Pc host, bool host_writes, Pc kernel, bool kernel_writes) {
    Finding finding;
    finding.kind = "host-reads-device";
    finding.place = place_of(host);
    finding.other = Finding::Other{place_of(kernel), kernel_writes ? "write" : "read", {}};
    if (finding.place.file.empty() || finding.other->place.file.empty()) return; // of a library
    finding.mode = "watch";
    finding.message = std::string("host code ") + (host_writes ? "writes" : "reads") +
                      " a variable that a kernel " + (kernel_writes ? "writes" : "reads") +
                      ": on a GPU each of the two has its own copy";
    finding.advice = "declare it __device__ or __constant__, and let host code use "
                     "cudaMemcpyToSymbol() and cudaMemcpyFromSymbol()";
    emit(finding);
}

void say_foreign_local(bool writes, Pc pc) {
    Finding finding;
    finding.kind = "foreign-local";
    finding.place = place_of(pc);
    if (finding.place.file.empty()) return; // of a header here
    finding.actor = running_actor();
    finding.mode = "watch";
    finding.message = std::string("the kernel ") + (writes ? "writes" : "reads") +
                      " a local variable of another thread: on a GPU the address means another "
                      "place in each thread";
    finding.advice = "put what threads share into __shared__ or global memory";
    emit(finding);
}

Finding too_deep(size_t calls, size_t stack_bytes, Pc call) {
    Finding finding;
    finding.kind = "stack-overflow";
    finding.place = place_of(call);
    finding.actor = running_actor();
    finding.mode = "watch";
    finding.message = std::to_string(calls) + " calls deep: the stack of a GPU's thread has " +
                      std::to_string(stack_bytes) + " bytes";
    finding.advice =
        "use a loop, or raise the limit: cudaDeviceSetLimit(cudaLimitStackSize, bytes)";
    return finding;
}

void say_unwritten_copy(const CopyCall& call, const Range& arena) {
    if (arena.has(uintptr_t(call.to))) return;
    constexpr size_t least = 16; // bytes side by side: not the padding of a struct
    const size_t first = uintptr_t(call.from) - arena.begin, end = first + call.bytes;
    size_t unwritten = 0, run = 0, longest = 0, longest_begin = 0;
    for (size_t byte = first; byte < end; ++byte) {
        const bool is_written = arena.written.of_word(byte / 4) >> byte % 4 & 1;
        unwritten += !is_written;
        run = is_written ? 0 : run + 1;
        if (run > longest) {
            longest = run;
            longest_begin = byte + 1 - run;
        }
    }
    if (unwritten == 0 || (longest < least && unwritten < call.bytes)) return;
    Finding finding;
    finding.kind = "uninitialised-copy";
    finding.severity = Severity::note;
    finding.place = {call.where.file, call.where.line, 0};
    finding.mode = "watch";
    finding.message = "of the " + std::to_string(call.bytes) + " bytes that are copied, " +
                      std::to_string(unwritten) + " were never written, from byte " +
                      std::to_string(longest_begin - first) + " on";
    finding.advice = "if host code uses them, launch enough blocks, (n + block - 1) / block, or "
                     "clear the memory with cudaMemset()";
    emit(finding);
}

} // namespace raylab::simt::watch
