// Failed checks of indices, divisions and alignment (undefined.h).
#include "common/simt/watch/undefined.h"

#include "common/simt/engine/block.h"
#include "common/simt/watch/say.h"
#include "common/simt/watch/say_text.h"
#include "common/simt/watch/watcher.h"

using namespace raylab::simt;
using namespace raylab::simt::watch;

namespace {

// Host code has compilers' own sanitizers; here only kernels matter.
void say(const char* kind, const SourceLocation& at, const std::string& message,
         const std::string& advice) {
    if (!Watcher::get().in_kernel()) return;
    Finding finding;
    finding.kind = kind;
    finding.place = {at.file, int(at.line), int(at.column)};
    finding.message = message;
    finding.advice = advice;
    finding.actor = running_actor();
    finding.mode = "watch";
    emit(finding);
}

} // namespace

extern "C" {

void __ubsan_handle_out_of_bounds(void* data, uintptr_t index) {
    const auto& d = *static_cast<const OutOfBoundsData*>(data);
    say("index-out-of-bounds", d.location,
        "index " + std::to_string(std::intptr_t(index)) + " is out of bounds of an array of type " +
            d.array->name,
        "an array of n elements has the indices 0 to n - 1, in each of its dimensions");
}

void __ubsan_handle_divrem_overflow(void* data, uintptr_t, uintptr_t divisor) {
    const auto& d = *static_cast<const OverflowData*>(data);
    if (divisor != 0) return;
    say("division-by-zero", d.location, "the kernel divides an integer by zero",
        "check the divisor first; on a GPU the result is not defined");
}

void __ubsan_handle_type_mismatch_v1(void* data, uintptr_t address) {
    const auto& d = *static_cast<const TypeMismatchData*>(data);
    const uintptr_t alignment = uintptr_t(1) << d.log_alignment;
    if (address % alignment == 0) return; // a null pointer: the access itself is looked at
    say("misaligned", d.location,
        std::string("the address of a ") + d.type->name + " is no multiple of " +
            std::to_string(alignment),
        "vector types such as float4 need an address that is a multiple of their size");
}
}
