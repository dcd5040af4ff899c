// AddressSanitizer and UndefinedBehaviorSanitizer: what is wrong, in CUDA's terms.
#include "common/simt/engine/sanitizer_reports.h"

#if defined(RAYLAB_CHECK_ADDRESS)

#include "common/simt/engine/block.h"
#include "common/simt/engine/environment.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/interrupted.h"
#include "common/simt/engine/machine.h"
#include "common/simt/engine/memory.h"
#include "common/simt/engine/where_is.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace raylab::simt {

namespace {

Finding started(const Fault& fault) {
    Finding finding;
    finding.place = user_place(fault);
    if (current_block) finding.actor = current_block->actor();
    return finding;
}

// What the address is in that is no device memory. The sanitizer is not asked: it holds its locks.
std::string describe_other(const void* address, const std::string& error) {
    if (error.starts_with("stack-")) return "in or behind a local array";
    if (const auto variable = variable_at(address))
        return "byte " + std::to_string(variable->offset) + " of the " +
               std::to_string(variable->bytes) + " bytes of '" + variable->name + "'";
    if (current_block && current_block->shared()) {
        const auto start = static_cast<const char*>(current_block->shared());
        const auto byte = static_cast<const char*>(address) - start;
        if (byte >= 0 && byte < 1 << 17)
            return "byte " + std::to_string(byte) + " of the " +
                   std::to_string(current_block->shared_bytes()) +
                   " bytes of dynamic shared memory";
    }
    return describe_address(address);
}

struct Words {
    const char *kind, *what, *advice;
};

Words words_for(const std::string& error, const Target& target) {
    if (error == "alloc-dealloc-mismatch" || error == "bad-free") // the address is not told
        return {"bad-free", "free() or delete is given memory that comes from elsewhere",
                "give device memory to cudaFree()"};
    if (!current_block && target.is_device())
        return {"host-dereference", "host code uses a device pointer",
                "copy with cudaMemcpy(), and use the copy"};
    if (error == "heap-use-after-free")
        return {"use-after-free", "memory is used after it was freed",
                "free it after the last launch that uses it"};
    if (error == "stack-overflow")
        return {"stack-overflow", "the stack is full",
                "end the recursion, or make local arrays smaller"};
    if (error.starts_with("stack-"))
        return {"local-overrun", "out of bounds of a local array",
                "test the index against the array's length"};
    return {"out-of-bounds", "out of bounds",
            "test the index against the number of elements: if (i < n)"};
}

void record_address_error() {
    void* address = __asan_get_report_address();
    const std::string error = __asan_get_report_description();
    const Target target = look_up(address);
    const Words words = words_for(error, target);
    Finding finding = started(callers_of(static_cast<char*>(__asan_get_report_pc()) - 1));
    finding.kind = words.kind;
    finding.advice = words.advice;
    const bool is_of_device = target.known || !describe_freed(address).empty();
    const std::string place =
        is_of_device ? describe_address(address) : describe_other(address, error);
    const size_t size = __asan_get_report_access_size();
    finding.message = std::string(words.what) + ": " + std::to_string(size) +
                      (size == 1 ? " byte is " : " bytes are ") +
                      (__asan_get_report_access_type() ? "written" : "read") + ", " + place;
    if (finding.kind == "bad-free") finding.message = words.what;
    if (error.find("-size") != error.npos || error.find("overlap") != error.npos)
        finding.message = error; // of a call, not of an access
    record(std::move(finding));
}

} // namespace

void record_races() {}

} // namespace raylab::simt

// AddressSanitizer calls this before it prints an error and ends the program.
extern "C" void __asan_on_error() {
    using namespace raylab::simt;
    record_address_error();
    write_summary();
    std::fflush(stdout);
    if (!print_reports()) return;
    const Target target = look_up(__asan_get_report_address());
    std::string text = "\n";
    if (current_block)
        text += "raylab: the memory error below is in " + current_block->running() + "\n";
    else if (target.is_device() && target.kind == MemoryKind::device)
        text += "raylab: host code dereferenced a device pointer: use cudaMemcpy()\n";
    if (target.known) text += "raylab: the address is " + describe(target) + "\n";
    std::fputs(text.c_str(), stderr);
}

// UndefinedBehaviorSanitizer calls this before it prints one; the program may go on.
extern "C" void __ubsan_on_report() {
    using namespace raylab::simt;
    record_undefined_behaviour();
    write_summary();
}

#elif !defined(RAYLAB_CHECK_THREAD)

void raylab::simt::record_races() {}

#endif
