#include "app/grade/grade_report.h"

#include "grader/report/report.h"

#include <fmt/format.h>

namespace raylab::app {

namespace {

ReportEntry entry_of(const grading::JudgedPicture& judged, const Marks& marks) {
    ReportEntry entry;
    // The page tells its entries apart by scene and lab, so that each picture needs a name.
    entry.scene = judged.picture.scene + (judged.picture.roulette ? "" : " without roulette");
    for (const std::string& option : judged.picture.options) entry.scene += " " + option;
    if (judged.hidden) entry.scene += " (made for this submission)";
    entry.title = entry.scene;
    entry.reason = fmt::format("For tasks {}.", fmt::join(judged.picture.tasks, ", "));
    entry.lab = marks.lab;
    if (!judged.drawn) {
        entry.decided = false;
        entry.verdict = {false, "Not drawn: a task that it needs is not done.", {}, {}};
        return entry;
    }
    const grading::PictureResult& result = judged.result;
    entry.passed = result.verdict == MarkVerdict::pass;
    entry.seconds = result.seconds;
    if (!judged.hidden) {
        if (result.judged) entry.verdict = *result.judged;
        entry.image = result.image;
        entry.reference = result.reference;
    }
    entry.verdict.passed = entry.passed;
    entry.verdict.sentence =
        fmt::format("{}: {}", name(result.verdict),
                    judged.hidden ? "a scene made for this submission" : result.sentence);
    return entry;
}

} // namespace

void write_grade_report(const grading::Graded& graded, const std::string& folder) {
    Report report;
    report.title = fmt::format("{}: {} of {} points", graded.marks.title, graded.marks.points(),
                               graded.marks.of_points());
    report.machine = graded.marks.sandbox;
    report.command = graded.marks.grader;
    for (const grading::JudgedPicture& judged : graded.pictures)
        report.entries.push_back(entry_of(judged, graded.marks));
    write_report(report, folder);
}

} // namespace raylab::app
