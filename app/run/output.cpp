// The report for people, and the annotations that GitHub shows beside the lines; see output.h.
#include "app/run/output.h"

#include "app/run/process_words.h"
#include "common/cli/progress.h"
#include "common/simt/finding_text.h"
#include "grader/results/text.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <utility>

namespace raylab::app {

using simt::Finding;
using simt::in_words;
using simt::Severity;

namespace {

std::string plural(std::uint64_t count, const std::string& one) {
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : one.ends_with("h") ? "es" : "s");
}

std::string human_bytes(std::uint64_t bytes) {
    if (bytes < 10240) return plural(bytes, "byte");
    if (bytes < (10u << 20)) return fmt::format("{} KiB", bytes >> 10);
    return fmt::format("{} MiB", bytes >> 20);
}

// How a program ended that has no finding to say so.
std::string ending(const Execution& execution) {
    const ProcessResult& process = execution.process;
    if (process.timed_out) return "was ended, for it ran too long outside of kernels";
    if (process.signal != 0)
        return fmt::format("was ended by signal {} ({})", process.signal,
                           strsignal(process.signal));
    if (process.exit_code > 0) return fmt::format("returned {}", process.exit_code);
    return {};
}

// One line a mode: those of the orders are alike.
std::string all_that_was_checked(const Result& result) {
    std::string text, last;
    for (const Execution& execution : result.executions)
        if (std::exchange(last, execution.mode) != execution.mode)
            text += "checked " + what_was_checked(execution) + "\n";
    return text;
}

} // namespace

std::string what_was_checked(const Execution& execution) {
    std::string text = execution.mode;
    if (execution.mode == "order") text += " (forward, reverse and random)";
    if (const auto& summary = execution.summary)
        text += fmt::format(": {}, {}, {} allocated, {}", plural(summary->launches, "launch"),
                            plural(summary->threads, "CUDA thread"), human_bytes(summary->bytes),
                            human_duration(execution.process.seconds));
    else
        text += ": no kernel was run";
    const std::string how = ending(execution);
    return how.empty() ? text : text + "; the program " + how;
}

std::string to_text(const Result& result) {
    std::string text;
    for (const Finding& finding : result.findings) text += simt::to_text(finding);
    if (result.executions.empty())
        return result.findings.empty() ? last_lines(result.compiler) + "does not compile\n"
                                       : text + "does not compile: nothing was run\n";
    std::array<std::uint64_t, 3> counts{};
    for (const Finding& finding : result.findings) ++counts[std::size_t(finding.severity)];
    std::string sums;
    for (Severity severity : {Severity::error, Severity::warning, Severity::note})
        if (const auto count = counts[std::size_t(severity)])
            sums += (sums.empty() ? "" : ", ") + plural(count, name(severity));
    bool ran = false;
    text += all_that_was_checked(result);
    for (const Execution& execution : result.executions) ran |= execution.summary.has_value();
    if (!result.unchecked.empty())
        text += "not checked: whether kernels use host code (" + result.unchecked + ")\n";
    if (sums.empty()) sums = ran ? "nothing found" : "no kernel was run: nothing was checked";
    return text + sums + "\n";
}

std::string to_github(const Result& result) {
    std::string text;
    for (const Finding& finding : result.findings) {
        const char* level = finding.severity == Severity::note ? "notice" : name(finding.severity);
        std::string words = finding.message;
        for (const std::string& more :
             {in_words(finding.actor), finding.other ? simt::other_end(finding) : std::string(),
              finding.advice.empty() ? std::string() : "to mend it: " + finding.advice})
            if (!more.empty()) words += "\n" + more;
        std::string where = "file=" + escape_github(finding.place.file, true);
        if (finding.place.line > 0) where += fmt::format(",line={}", finding.place.line);
        if (finding.place.column > 0) where += fmt::format(",col={}", finding.place.column);
        text += fmt::format("::{} {},title={}::{}\n", level, where,
                            escape_github(finding.kind, true), escape_github(words, false));
    }
    return text + all_that_was_checked(result);
}

} // namespace raylab::app
