#include "grader/class/class_page.h"

#include "grader/class/class_page_parts.h"
#include "grader/class/item_analysis.h"
#include "grader/class/run_class.h"
#include "grader/class/standing.h"
#include "grader/report/html.h"
#include "grader/results/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

std::string escaped(const std::string& text) {
    return escape_html(clean_utf8(shortened(text, 1000)));
}

// Colour alone tells nothing to some readers: each verdict has a sign, too.
const char* sign_of(MarkVerdict verdict) {
    switch (verdict) {
    case MarkVerdict::pass:
        return "&#10003;";
    case MarkVerdict::not_implemented:
    case MarkVerdict::not_run:
        return "&ndash;";
    case MarkVerdict::internal:
    case MarkVerdict::suspicious:
    case MarkVerdict::unsandboxed:
        return "!";
    default:
        return "&#10007;";
    }
}

const char* class_of(MarkVerdict verdict) {
    switch (verdict) {
    case MarkVerdict::pass:
        return "pass";
    case MarkVerdict::not_implemented:
    case MarkVerdict::not_run:
        return "none";
    case MarkVerdict::internal:
    case MarkVerdict::suspicious:
    case MarkVerdict::unsandboxed:
        return "look";
    default:
        return "fail";
    }
}

std::string names(const JournalRow& row) {
    std::string text;
    for (const Student& student : row.students)
        text +=
            (text.empty() ? "" : ", ") + escaped(student.name.empty() ? student.id : student.name);
    return text;
}

// The first reason in sight, all others behind it.
std::string reasons(const JournalRow& row, const Standing& standing) {
    std::string items;
    if (row.graded.marks)
        for (const Mark& mark : row.graded.marks->tasks)
            if (mark.verdict != MarkVerdict::pass)
                items += fmt::format("<li><b>{} {}</b> {}</li>", escaped(mark.id),
                                     name(mark.verdict), escaped(explanation(mark)));
    for (const auto& [what, files] :
         {std::pair("missing", &row.missing), std::pair("not used", &row.ignored)})
        if (!files->empty())
            items += fmt::format("<li>{}: {}</li>", what,
                                 escaped(fmt::format("{}", fmt::join(*files, ", "))));
    if (items.empty()) return escaped(standing.reason);
    const std::string first = standing.reason.empty() ? "about its files" : standing.reason;
    return fmt::format("<details><summary>{}</summary><ul>{}</ul></details>", escaped(first),
                       items);
}

std::string row_html(const JournalRow& row, const LabSheet& sheet, const fs::path& folder) {
    const Standing standing = standing_of(row);
    std::string cells;
    for (const Task& task : sheet.tasks) {
        const Mark* mark = mark_of(row, task.id);
        const MarkVerdict verdict = mark ? mark->verdict : MarkVerdict::not_run;
        cells += fmt::format(
            "<td class=\"task {0}\" data-sort=\"{1}\"><abbr title=\"{2} {3}: {4} of {5}\">"
            "{6}</abbr></td>",
            class_of(verdict), mark ? mark->points() : -1, escaped(task.id), name(verdict),
            mark ? mark->points() : 0, task.points, sign_of(verdict));
    }
    std::string who = names(row);
    const std::string report = "runs/" + row.graded.run + "/report.html";
    if (!row.graded.run.empty() && fs::exists(folder / report))
        who = fmt::format("<a href=\"{}\">{}</a>", escaped(report), who);
    return fmt::format(
        "<tr data-verdict=\"{0}\"><th scope=\"row\">{1}<small>{2}{3}</small></th>"
        "<td class=\"number\" data-sort=\"{4}\">{5}</td><td data-sort=\"{0}\">"
        "<span class=\"verdict {6}\">{0}</span></td>{7}<td class=\"why\">{8}</td></tr>\n",
        row.waits && !row.graded.marks ? "WAITING" : name(standing.verdict), who, escaped(row.id),
        row.late ? " <em>late</em>" : "", standing.score.value_or(-1),
        standing.score ? std::to_string(*standing.score) : "&ndash;", class_of(standing.verdict),
        cells, reasons(row, standing));
}

std::string item_rows(const ClassFigures& figures) {
    std::string rows;
    for (const TaskFigures& task : figures.tasks) {
        std::string verdicts;
        for (const auto& [verdict, count] : task.verdicts)
            if (verdict != MarkVerdict::pass)
                verdicts +=
                    fmt::format("{}{} {}", verdicts.empty() ? "" : ", ", count, name(verdict));
        const std::string cause = task.cause.empty()
                                      ? ""
                                      : fmt::format("{} ({} of {})", escaped(task.cause),
                                                    task.named, task.graded - task.passed);
        rows += fmt::format("<tr><th scope=\"row\">{} {}</th><td class=\"number\">{} of {}</td>"
                            "<td><meter min=\"0\" max=\"1\" value=\"{:.3f}\"></meter> "
                            "{:.0f}&#8239;%</td><td>{}</td><td>{}</td></tr>\n",
                            escaped(task.id), escaped(task.title), task.passed, task.graded,
                            task.passed_share(), 100 * task.passed_share(), verdicts, cause);
    }
    return rows;
}

// How many have how many points, in ten bars.
std::string histogram(const ClassFigures& figures, int of_points) {
    if (figures.scores.empty() || of_points == 0) return "";
    constexpr int bars = 10, width = 32, height = 70;
    std::vector<int> counts(bars);
    for (const int score : figures.scores)
        ++counts[static_cast<std::size_t>(std::min(bars - 1, bars * score / of_points))];
    const int most = *std::max_element(counts.begin(), counts.end());
    std::string svg;
    for (int i = 0; i < bars; ++i) {
        const int count = counts[static_cast<std::size_t>(i)], h = height * count / most;
        svg += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{} to {} points: {} "
            "submissions</title></rect>",
            i * width + 1, height - h, width - 2, h, (i * of_points + bars - 1) / bars,
            i + 1 == bars ? of_points : ((i + 1) * of_points + bars - 1) / bars - 1, count);
    }
    return fmt::format(
        "<figure><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Points of the "
        "class\">{}</svg>"
        "<figcaption>Points, from 0 to {}; the median is {:g}.</figcaption></figure>\n",
        bars * width, height, svg, of_points, figures.median_score());
}

std::string summary(const ClassFigures& figures) {
    std::string text = fmt::format("<strong>{}</strong> submissions", figures.submissions);
    const auto add = [&text](int count, const char* what) {
        if (count > 0) text += fmt::format(", {} {}", count, what);
    };
    add(figures.late, "late");
    add(figures.refused, "refused");
    add(figures.internal, "with trouble of the grader's own");
    add(figures.waiting, "not graded yet");
    if (figures.median_tries)
        text += fmt::format("; the median of tries is {:g}", *figures.median_tries);
    return text;
}

// The verdicts that there are, for the filter.
std::string verdict_options(const Journal& journal) {
    std::map<std::string, int> counts;
    journal.each(Set::live, [&](const JournalRow& row) {
        ++counts[row.waits && !row.graded.marks ? "WAITING" : name(standing_of(row).verdict)];
    });
    std::string options = "<option value=\"\">every verdict</option>";
    for (const auto& [verdict, count] : counts)
        options += fmt::format("<option value=\"{0}\">{0} ({1})</option>", verdict, count);
    return options;
}

std::string heads(const LabSheet& sheet) {
    const auto head = [](const std::string& text, const std::string& title) {
        return fmt::format(
            "<th scope=\"col\" aria-sort=\"none\"><button type=\"button\" title=\"sort by {}\">{}"
            "</button></th>",
            title, text);
    };
    std::string text =
        head("Student", "name") + head("Points", "points") + head("Verdict", "verdict");
    for (const Task& task : sheet.tasks) text += head(escaped(task.id), escaped(task.title));
    return text + "<th scope=\"col\">Why</th>";
}

} // namespace

std::string class_page(const Journal& journal, const LabSheet& sheet, const fs::path& folder) {
    const ClassFigures figures = figures_of(journal, sheet);
    std::string rows;
    journal.each(Set::live, [&](const JournalRow& row) { rows += row_html(row, sheet, folder); });
    const std::string title = fmt::format("Lab {}: {}", sheet.number, sheet.title);
    const std::string body = fmt::format(
        "<header><h1>{0}</h1>\n<p class=\"summary\">{1}</p></header>\n{2}"
        "<h2>Tasks</h2><div class=\"wide\"><table id=\"items\"><thead><tr><th "
        "scope=\"col\">Task</th>"
        "<th scope=\"col\" class=\"number\">Passed</th><th scope=\"col\">Share</th><th "
        "scope=\"col\">Others</th>"
        "<th scope=\"col\">The commonest "
        "cause</th></tr></thead>\n<tbody>{3}</tbody></table></div>\n"
        "<h2>Submissions</h2>\n<form class=\"filter\" role=\"search\"><label>Find <input "
        "type=\"search\" "
        "id=\"find\" placeholder=\"name, number, words of a reason\"></label> <label>Show <select "
        "id=\"verdict\">{4}</select></label> <output id=\"shown\"></output></form>\n"
        "<noscript><p>Filter and order need JavaScript; all text is here without "
        "it.</p></noscript>\n"
        "<div class=\"wide\"><table "
        "id=\"class\"><thead><tr>{5}</tr></thead>\n<tbody>{6}</tbody></table></div>\n",
        escaped(title), summary(figures), histogram(figures, points_of(sheet)), item_rows(figures),
        verdict_options(journal), heads(sheet), rows);
    return html_page({title, class_page_css, body, "{}", class_page_js});
}

} // namespace raylab
