// The engine's reports have one form (report.h), and this reads it back: so every report is also a
// finding, whoever wrote it.
//
//     f.cu:41: error: WHAT
//       kernel k, launched at f.cu:60, grid (1,1,1), block size (64,1,1)
//       block (0,0,0), thread (3,0,0)
//       f.cu:44: 16 threads wait at __syncthreads(), the first is thread (0,0,0)
//       expected: ...
//       to do: ...
#include "common/simt/engine/findings.h"

#include <cstdio>
#include <sstream>

namespace raylab::simt {

namespace {

constexpr struct {
    const char *words, *kind;
} kinds[] = {
    {"null pointer", "null-pointer"},
    {"wild address", "wild-address"},
    {"stack overflow", "stack-overflow"},
    {"overrun of dynamic shared memory", "shared-overrun"},
    {"overrun of a local array", "local-overrun"},
    {"division by zero", "division-by-zero"},
    {"does not end", "endless-loop"},
    {"abort()", "abort"},
    {"bad source", "bad-source"},
    {"bad mask", "bad-mask"},
    {"exit before a barrier", "exit-before-barrier"},
    {"divergent barrier", "divergent-barrier"},
    {"deadlock", "deadlock"},
    {"__trap()", "trap"},
    {"assertion", "assert"},
    {"no memory for the stacks", "no-stacks"},
    {"no memory for", "out-of-memory"},
    {"cannot be launched", "bad-launch"},
    {"freed pointer", "freed-pointer"},
    {"host pointer", "host-pointer"},
    {"to be freed", "bad-free"},
    {"the destination is", "bad-copy"},
    {"the source is", "bad-copy"},
    {"direction of a copy", "bad-copy"},
    {"a pitch of", "bad-copy"},
    {"host code writes device memory", "host-dereference"},
    {"a block has returned", "exit-before-barrier"},
    {"device memory leak", "leak"},
    {" launches ", "launch-in-kernel"},
    {"called by host code", "outside-of-kernel"},
};

// "f.cu:41", or "f.cu:41:7" with a column.
SourcePlace place_in(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == text.npos || colon + 1 == text.size()) return {};
    if (text.find_first_not_of("0123456789", colon + 1) != text.npos) return {};
    const int number = std::atoi(text.c_str() + colon + 1);
    const std::string before = text.substr(0, colon);
    if (SourcePlace place = place_in(before); place.line > 0) {
        place.column = number;
        return place;
    }
    return {before, number, 0};
}

std::optional<Index3> index_after(const std::string& text, const char* word) {
    const std::size_t at = text.find(word);
    Index3 index{};
    if (at == text.npos || std::sscanf(text.c_str() + at + std::string(word).size(), "(%u,%u,%u)",
                                       &index[0], &index[1], &index[2]) != 3)
        return {};
    return index;
}

void read_line(const std::string& line, Finding& finding, std::string& expected) {
    const auto after = [&](const char* start) {
        const bool there = line.starts_with(start);
        return there ? line.substr(std::string(start).size()) : std::string();
    };
    if (std::string todo = after("  to do: "); !todo.empty()) {
        finding.advice = todo;
    } else if (std::string text = after("  expected: "); !text.empty()) {
        expected = text;
    } else if (std::string kernel = after("  kernel "); !kernel.empty()) {
        finding.actor.kernel = kernel.substr(0, kernel.find(", launched at "));
    } else if (line.starts_with("  block (")) {
        finding.actor.block = index_after(line, "block ");
        finding.actor.thread = index_after(line, "thread ");
    } else if (const std::size_t colon = line.find(": "); colon != line.npos && !finding.other) {
        const SourcePlace place = place_in(line.substr(2, colon - 2));
        if (place.line == 0 || place == finding.place) return;
        const std::string what = line.substr(colon + 2);
        finding.other = {place, what.substr(0, what.find(", the first")), {}};
        finding.other->actor.thread = index_after(what, "the first is thread ");
    }
}

} // namespace

Finding finding_of_report(const std::string& report) {
    Finding finding;
    std::istringstream lines(report);
    std::string first, expected;
    std::getline(lines, first);
    const std::string mark = "error: ";
    const std::size_t at = first.find(mark);
    finding.message = at == first.npos ? first : first.substr(at + mark.size());
    if (at != first.npos && at > 2) finding.place = place_in(first.substr(0, at - 2));
    finding.kind = "misuse";
    for (const auto& known : kinds)
        if (finding.message.find(known.words) != std::string::npos) {
            finding.kind = known.kind;
            break;
        }
    if (finding.message.starts_with("kernel ")) {
        const std::string rest = finding.message.substr(7);
        for (const char* end : {" cannot be launched", " is given "})
            if (const std::size_t stop = rest.find(end); stop != rest.npos)
                finding.actor.kernel = rest.substr(0, stop);
    }
    for (std::string line; std::getline(lines, line);) read_line(line, finding, expected);
    if (finding.advice.empty() && !expected.empty()) finding.advice = "expected: " + expected;
    return finding;
}

} // namespace raylab::simt
