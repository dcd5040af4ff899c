#include "grader/results/marks.h"

#include "grader/results/text.h"

#include <sstream>

namespace raylab {

const char* name(MarkVerdict verdict) {
    switch (verdict) {
    case MarkVerdict::not_run:
        return "NOT_RUN";
    case MarkVerdict::not_implemented:
        return "NOT_IMPLEMENTED";
    case MarkVerdict::compile_error:
        return "COMPILE_ERROR";
    case MarkVerdict::wrong:
        return "WRONG";
    case MarkVerdict::wrong_image:
        return "WRONG_IMAGE";
    case MarkVerdict::non_finite:
        return "NON_FINITE";
    case MarkVerdict::wrong_size:
        return "WRONG_SIZE";
    case MarkVerdict::time_limit:
        return "TIME_LIMIT";
    case MarkVerdict::memory_limit:
        return "MEMORY_LIMIT";
    case MarkVerdict::output_limit:
        return "OUTPUT_LIMIT";
    case MarkVerdict::crash:
        return "CRASH";
    case MarkVerdict::no_output:
        return "NO_OUTPUT";
    case MarkVerdict::suspicious:
        return "SUSPICIOUS";
    case MarkVerdict::unsandboxed:
        return "UNSANDBOXED";
    case MarkVerdict::internal:
        return "INTERNAL";
    case MarkVerdict::pass:
        return "PASS";
    }
    return "";
}

const std::vector<MarkVerdict>& all_verdicts() {
    static const std::vector<MarkVerdict> all = {
        MarkVerdict::not_run,      MarkVerdict::not_implemented, MarkVerdict::compile_error,
        MarkVerdict::wrong,        MarkVerdict::wrong_image,     MarkVerdict::non_finite,
        MarkVerdict::wrong_size,   MarkVerdict::time_limit,      MarkVerdict::memory_limit,
        MarkVerdict::output_limit, MarkVerdict::crash,           MarkVerdict::no_output,
        MarkVerdict::suspicious,   MarkVerdict::unsandboxed,     MarkVerdict::internal,
        MarkVerdict::pass};
    return all;
}

std::optional<MarkVerdict> verdict_named(std::string_view text) {
    for (const MarkVerdict verdict : all_verdicts())
        if (name(verdict) == text) return verdict;
    return std::nullopt;
}

std::string explanation(const Mark& mark) {
    std::string text;
    for (const std::string& reason : mark.reasons) text += reason + "\n";
    if (mark.verdict != MarkVerdict::pass && !mark.read_on.empty())
        text += "read on in the handout: " + mark.read_on + "\n";
    return text;
}

std::string first_error(const std::string& compiler) {
    std::istringstream lines(compiler);
    for (std::string line; std::getline(lines, line);)
        if (line.find("error: ") != line.npos) return line;
    return compiler.substr(0, compiler.find('\n'));
}

MarkVerdict overall(const Marks& marks) {
    using enum MarkVerdict;
    if (!marks.trouble.empty()) return internal;
    if (!marks.compiler.empty()) return compile_error;
    if (marks.passed()) return pass;
    // What somebody should look at comes first, what is yet to be written last.
    for (const MarkVerdict grave :
         {internal, suspicious, unsandboxed, compile_error, crash, memory_limit, output_limit,
          time_limit, no_output, wrong_size, non_finite, wrong_image, wrong, not_implemented})
        for (const Mark& mark : marks.tasks)
            if (mark.verdict == grave) return grave;
    return not_run;
}

namespace {

// At most twenty, since a submission may come with 100,000 files.
std::string some_of(const std::vector<std::string>& files) {
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, files.size()); ++i)
        text += (i ? ", " : "") + shortened(files[i], 200);
    if (files.size() > most) text += ", and " + std::to_string(files.size() - most) + " more";
    return text;
}

} // namespace

std::string circumstances(const Marks& marks) {
    std::string text;
    if (!marks.missing.empty()) text += "missing: " + some_of(marks.missing) + "\n";
    if (!marks.ignored.empty()) text += "not used: " + some_of(marks.ignored) + "\n";
    if (!marks.sandbox.empty()) text += "sandbox: " + marks.sandbox + "\n";
    return text;
}

} // namespace raylab
