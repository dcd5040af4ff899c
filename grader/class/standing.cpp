#include "grader/class/standing.h"

#include "grader/results/text.h"

#include <algorithm>
#include <cctype>

namespace raylab {

namespace {

std::string on_one_line(const std::string& text) {
    std::string line = clean_utf8(shortened(text, 400));
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

// Of the verdict that the whole is called by.
std::string first_reason(const Marks& marks) {
    if (!marks.compiler.empty()) return first_error(marks.compiler);
    for (const Mark& mark : marks.tasks)
        if (mark.verdict == overall(marks) && mark.verdict != MarkVerdict::pass &&
            !mark.reasons.empty())
            return mark.id + ": " + mark.reasons.front();
    return "";
}

} // namespace

Standing standing_of(const JournalRow& row) {
    Standing standing;
    if (!row.refused.empty()) {
        standing.score = 0;
        standing.reason = on_one_line(row.refused);
        return standing;
    }
    standing.verdict = row.graded.verdict();
    if (row.graded.marks) {
        standing.score = row.graded.marks->points();
        standing.reason = on_one_line(first_reason(*row.graded.marks));
    }
    if (!row.graded.trouble.empty()) standing.reason = on_one_line(row.graded.trouble);
    return standing;
}

const Mark* mark_of(const JournalRow& row, const std::string& task) {
    if (!row.graded.marks) return nullptr;
    for (const Mark& mark : row.graded.marks->tasks)
        if (mark.id == task) return &mark;
    return nullptr;
}

int points_of(const LabSheet& sheet) {
    int sum = 0;
    for (const Task& task : sheet.tasks) sum += task.points;
    return sum;
}

std::string cause_in(const std::string& reason) {
    static const std::string named = "the likely cause: ";
    const std::size_t at = reason.find(named);
    return on_one_line(at == reason.npos ? reason : reason.substr(at + named.size()));
}

std::string without_figures(const std::string& cause) {
    std::string folded;
    for (std::size_t i = 0; i < cause.size(); ++i) {
        const auto is_digit = [&](std::size_t k) {
            return k < cause.size() && std::isdigit(static_cast<unsigned char>(cause[k]));
        };
        if (!is_digit(i)) {
            folded += cause[i];
            continue;
        }
        folded += '#';
        while (is_digit(i + 1) || (i + 1 < cause.size() && cause[i + 1] == '.' && is_digit(i + 2)))
            ++i;
    }
    return folded;
}

} // namespace raylab
