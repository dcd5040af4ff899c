#include "grader/class/item_analysis.h"

#include "grader/class/standing.h"

#include <algorithm>

namespace raylab {

namespace {

double median(std::vector<int> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// A cause as one submission has it, and how many have it but for its figures.
struct Cause {
    std::string example;
    int named = 0;
};
using Causes = std::map<std::string, Cause>; // by without_figures()

void count(TaskFigures& figures, Causes& causes, const Mark& mark) {
    if (mark.verdict == MarkVerdict::internal) return;
    ++figures.graded;
    figures.passed += mark.verdict == MarkVerdict::pass;
    ++figures.verdicts[mark.verdict];
    if (mark.verdict != MarkVerdict::pass && mark.verdict != MarkVerdict::not_implemented &&
        !mark.reasons.empty()) {
        const std::string cause = cause_in(mark.reasons.front());
        Cause& known = causes[without_figures(cause)];
        if (++known.named == 1) known.example = cause;
    }
}

void set_cause(TaskFigures& figures, const Causes& causes) {
    for (const auto& [folded, cause] : causes)
        if (cause.named > figures.named) figures.cause = cause.example, figures.named = cause.named;
}

} // namespace

double ClassFigures::median_score() const { return median(scores); }

ClassFigures figures_of(const Journal& journal, const LabSheet& sheet) {
    ClassFigures figures;
    for (const Task& task : sheet.tasks) {
        figures.tasks.emplace_back();
        figures.tasks.back().id = task.id;
        figures.tasks.back().title = task.title;
        figures.tasks.back().of_points = task.points;
    }
    std::vector<Causes> causes(sheet.tasks.size());
    std::vector<int> tries;
    journal.each(Set::live, [&](const JournalRow& row) {
        const Standing standing = standing_of(row);
        ++figures.submissions;
        figures.waiting += row.waits;
        figures.refused += !row.refused.empty();
        figures.internal += standing.verdict == MarkVerdict::internal;
        figures.late += row.late;
        if (standing.score) figures.scores.push_back(*standing.score);
        if (row.tries > 0) tries.push_back(row.tries);
        for (std::size_t i = 0; i < figures.tasks.size(); ++i)
            if (const Mark* mark = mark_of(row, figures.tasks[i].id))
                count(figures.tasks[i], causes[i], *mark);
    });
    for (std::size_t i = 0; i < causes.size(); ++i) set_cause(figures.tasks[i], causes[i]);
    std::sort(figures.scores.begin(), figures.scores.end());
    if (!tries.empty()) figures.median_tries = median(tries);
    return figures;
}

} // namespace raylab
