#include "grader/class/differences.h"

#include "grader/class/standing.h"

#include <fmt/format.h>

namespace raylab {

namespace {

std::string names_of(const JournalRow& row) {
    std::string names;
    for (const Student& student : row.students)
        names += (names.empty() ? "" : ", ") + (student.name.empty() ? student.id : student.name);
    return names;
}

const char* verdict_of(const std::optional<Marks>& marks, const std::string& task) {
    if (marks)
        for (const Mark& mark : marks->tasks)
            if (mark.id == task) return name(mark.verdict);
    return "-";
}

std::vector<std::string> changes(const std::optional<Marks>& before, const Marks& after) {
    std::vector<std::string> lines;
    for (const Mark& mark : after.tasks) {
        const std::string old = verdict_of(before, mark.id);
        if (old != name(mark.verdict))
            lines.push_back(fmt::format("{}: {} -> {}", mark.id, old, name(mark.verdict)));
    }
    return lines;
}

std::string score(const std::optional<int>& points) {
    return points ? std::to_string(*points) : "-";
}

} // namespace

Differences differences_of(const Journal& journal) {
    Differences all;
    journal.each(Set::staged, [&](const JournalRow& row) {
        if (row.waits) {
            ++all.waiting;
        } else if (!row.graded.trouble.empty() || !row.graded.marks) {
            ++all.trouble;
        } else {
            const std::optional<Marks> before = journal.live(row.id).value_or(Graded()).marks;
            Difference one;
            one.id = row.id;
            one.names = names_of(row);
            if (before) one.before = before->points();
            one.after = row.graded.marks->points();
            one.lines = changes(before, *row.graded.marks);
            if (one.lines.empty() && one.before == one.after)
                ++all.same;
            else
                all.changed.push_back(one);
        }
    });
    return all;
}

std::string to_text(const Differences& differences) {
    std::string text;
    for (const Difference& one : differences.changed)
        text += fmt::format("{} ({}): {} -> {}; {}\n", one.id, one.names, score(one.before),
                            score(one.after), fmt::join(one.lines, ", "));
    text += fmt::format("{} differ, {} are the same", differences.changed.size(), differences.same);
    if (differences.trouble > 0)
        text +=
            fmt::format(", {} keep their marks since the grader had trouble", differences.trouble);
    if (differences.waiting > 0)
        text += fmt::format(", {} are not graded yet", differences.waiting);
    return text + "\n";
}

} // namespace raylab
