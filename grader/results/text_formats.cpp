// The formats that are no JSON: JUnit's XML, CSV, GitHub's annotations and summary.
#include "grader/results/formats.h"
#include "grader/results/marks_json.h"
#include "grader/results/text.h"

#include <fmt/format.h>

#include <stdexcept>

namespace raylab {

namespace {

constexpr std::size_t shown_annotations = 10, most_of_a_summary = 1000 << 10,
                      most_of_a_case = 64 << 10;

// JUnit tells apart what failed and what could not be tried.
bool is_error(const Mark& mark) {
    return mark.verdict == MarkVerdict::compile_error || mark.verdict == MarkVerdict::unsandboxed ||
           mark.verdict == MarkVerdict::internal;
}

std::string test_case(const Marks& marks, const Mark& mark) {
    std::string text =
        fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                    escape_xml(marks.lab), escape_xml(mark.id + " " + mark.title), mark.seconds);
    if (mark.verdict == MarkVerdict::pass) return text + "/>\n";
    const char* tag = is_error(mark) ? "error" : "failure";
    const std::string first = mark.reasons.empty() ? name(mark.verdict) : mark.reasons.front();
    return text + fmt::format(">\n    <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n  </testcase>\n",
                              tag, name(mark.verdict), escape_xml(shortened(first, 500)),
                              escape_xml(shortened(explanation(mark), most_of_a_case)));
}

// In a cell of a table; Markdown and HTML in it are text.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : clean_utf8(text)) {
        if (c == '\n')
            result += "<br>";
        else if (c == '&' || c == '<' || c == '>')
            result += escape_html(std::string_view(&c, 1));
        else if (std::string_view("|\\`*_[]#~").find(c) != std::string_view::npos)
            result += std::string("\\") + c;
        else
            result += c;
    }
    return result;
}

} // namespace

std::string junit(const Marks& marks) {
    std::string cases;
    int failures = 0, errors = 0;
    for (const Mark& mark : marks.tasks) {
        cases += test_case(marks, mark);
        errors += is_error(mark);
        failures += mark.verdict != MarkVerdict::pass && !is_error(mark);
    }
    if (!marks.trouble.empty()) {
        ++errors;
        cases += fmt::format("  <testcase classname=\"{}\" name=\"the grader itself\">\n    <error "
                             "type=\"INTERNAL\" message=\"{}\"/>\n  </testcase>\n",
                             escape_xml(marks.lab), escape_xml(shortened(marks.trouble, 2000)));
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
                       "time=\"{:.3f}\">\n{}</testsuite>\n",
                       escape_xml(marks.lab + ": " + marks.title),
                       marks.tasks.size() + !marks.trouble.empty(), failures, errors, marks.seconds,
                       cases);
}

std::string csv(const Marks& marks) {
    std::string names = "lab,score,max_score,trouble,grader",
                values = fmt::format("{},{},{},{},{}", csv_field(marks.lab), marks.points(),
                                     marks.of_points(), csv_field(marks.trouble),
                                     csv_field(marks.grader));
    for (const Mark& mark : marks.tasks) {
        names += fmt::format(",{0},{0}_verdict", mark.id);
        values += fmt::format(",{},{}", mark.points(), name(mark.verdict));
    }
    return names + "\r\n" + values + "\r\n";
}

std::string github_annotations(const Marks& marks) {
    if (!marks.trouble.empty())
        return fmt::format("::error title=INTERNAL::{}\n",
                           escape_github(clean_utf8(marks.trouble), false));
    std::vector<const Mark*> bad;
    for (const Mark& mark : marks.tasks)
        if (mark.verdict != MarkVerdict::pass) bad.push_back(&mark);
    std::stable_sort(bad.begin(), bad.end(), [](const Mark* a, const Mark* b) {
        return a->of_points > b->of_points; // the worst first
    });
    const bool folded = bad.size() > shown_annotations;
    const std::size_t shown = folded ? shown_annotations - 1 : bad.size();
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
        const Mark& mark = *bad[i];
        std::string where;
        if (!mark.file.empty()) where += "file=" + escape_github(clean_utf8(mark.file), true) + ",";
        if (!mark.file.empty() && mark.line > 0) where += fmt::format("line={},", mark.line);
        text += fmt::format(
            "::error {}title={}::{}\n", where,
            escape_github(
                clean_utf8(fmt::format("{} {} {}", name(mark.verdict), mark.id, mark.title)), true),
            escape_github(clean_utf8(shortened(explanation(mark), 4000)), false));
    }
    if (folded)
        text += fmt::format("::error title=And more::{} more tasks are not passed; the summary has "
                            "them all\n",
                            bad.size() - shown);
    return text;
}

std::string github_summary(const Marks& marks) {
    std::string text = fmt::format("### {}: {} of {} points\n\n", cell(marks.title), marks.points(),
                                   marks.of_points());
    if (!marks.trouble.empty()) text += "**INTERNAL:** " + cell(marks.trouble) + "\n\n";
    text += "| task | | points | |\n|---|---|--:|---|\n";
    for (const Mark& mark : marks.tasks) {
        std::string row = fmt::format("| {} {} | {} | {} of {} | {} |\n", cell(mark.id),
                                      cell(mark.title), cell(name(mark.verdict)), mark.points(),
                                      mark.of_points, cell(shortened(explanation(mark), 2000)));
        if (text.size() + row.size() > most_of_a_summary)
            return text + "\nThe rest did not fit: a summary has at most one megabyte.\n";
        text += row;
    }
    if (const std::string said = circumstances(marks); !said.empty())
        text += "\n" + cell(said) + "\n";
    return text;
}

std::string write_marks(const std::string& format, const Marks& marks) {
    if (format == "marks") return marks_json(marks);
    if (format == "gradescope") return gradescope(marks);
    if (format == "prairielearn") return prairielearn(marks);
    if (format == "classroom50") return classroom50(marks, Classroom50::from_environment());
    if (format == "junit") return junit(marks);
    if (format == "csv") return csv(marks);
    if (format == "github") return github_annotations(marks);
    if (format == "summary") return github_summary(marks);
    throw std::invalid_argument(fmt::format("there is no format '{}': expected {}", format,
                                            fmt::join(mark_formats(), ", ")));
}

const std::vector<std::string>& mark_formats() {
    static const std::vector<std::string> names = {
        "marks", "gradescope", "prairielearn", "classroom50", "junit", "csv", "github", "summary"};
    return names;
}

} // namespace raylab
