// UndefinedBehaviorSanitizer's reports as findings.
#include "common/simt/engine/sanitizer_reports.h"

#if defined(RAYLAB_CHECK_ADDRESS)

#include "common/simt/engine/block.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/interrupted.h"

#include <cctype>
#include <cstring>

extern "C" void __ubsan_get_current_report_data(const char** kind, const char** message,
                                                const char** file, unsigned* line, unsigned* column,
                                                char** address);

namespace raylab::simt {

namespace {

// The sanitizer's word, ours, and what to do. Arithmetic gives some number on a GPU, too: a
// warning.
constexpr struct {
    const char *word, *kind;
    Severity severity;
    const char* advice;
} known[] = {
    {"out-of-bounds-index", "index-out-of-bounds", Severity::error,
     "test the index against the array's length"},
    {"insufficient-object-size", "out-of-bounds", Severity::error,
     "test the index against the array's length"},
    {"null-pointer-use", "null-pointer", Severity::error,
     "allocate the memory with cudaMalloc(), check what it returned, and give the kernel that "
     "pointer"},
    {"misaligned-pointer-use", "misaligned", Severity::error,
     "use an address that is a multiple of the type's size"},
    {"integer-divide-by-zero", "division-by-zero", Severity::error,
     "test the divisor first; a GPU gives a meaningless number instead"},
    {"missing-return", "missing-return", Severity::error, "return a value on every way"},
    {"integer-overflow", "integer-overflow", Severity::warning,
     "compute with unsigned numbers or size_t"},
    {"invalid-shift", "invalid-shift", Severity::warning,
     "shift by 0 to 31 bits, or 63 of a long long"},
    {"float-cast-overflow", "float-cast-overflow", Severity::warning,
     "test that the value fits before it becomes an integer"},
};

} // namespace

void record_undefined_behaviour() {
    const char *word = nullptr, *message = nullptr, *file = nullptr;
    unsigned line = 0, column = 0;
    char* address = nullptr;
    __ubsan_get_current_report_data(&word, &message, &file, &line, &column, &address);
    Finding finding;
    finding.place = user_place(callers_of(nullptr));
    const bool same_file = file && finding.place.file == file;
    if (file && (same_file || finding.place.line == 0))
        finding.place = {file, int(line), int(column)};
    if (current_block) finding.actor = current_block->actor();
    finding.kind = word;
    finding.message = message;
    finding.message[0] = char(std::tolower(finding.message[0]));
    finding.advice = "C++ does not say what this does: write it another way";
    for (const auto& entry : known)
        if (std::strstr(word, entry.word)) {
            finding.kind = entry.kind;
            finding.severity = entry.severity;
            finding.advice = entry.advice;
            break;
        }
    record(std::move(finding));
}

} // namespace raylab::simt

#endif
