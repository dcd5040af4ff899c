#include "grader/class/class_csv.h"

#include "grader/class/standing.h"
#include "grader/results/text.h"

#include <fmt/format.h>

namespace raylab {

std::string class_csv(const Journal& journal, const LabSheet& sheet) {
    std::string text = "id,name,email,submission,late,lab,score,max_score,verdict,reason";
    for (const Task& task : sheet.tasks) text += fmt::format(",{0},{0}_max,{0}_verdict", task.id);
    text += ",missing,graded_at,grader\r\n";
    journal.each(Set::live, [&](const JournalRow& row) {
        const Standing standing = standing_of(row);
        std::string rest = fmt::format(
            "{},{},{},{},{},{},{}", csv_field(row.id), row.late ? "late" : "",
            csv_field(sheet.folder), standing.score ? std::to_string(*standing.score) : "",
            points_of(sheet), name(standing.verdict), csv_field(standing.reason));
        for (const Task& task : sheet.tasks) {
            const Mark* mark = mark_of(row, task.id);
            rest += fmt::format(",{},{},{}", mark ? std::to_string(mark->points()) : "",
                                task.points, mark ? name(mark->verdict) : "");
        }
        rest += fmt::format(
            ",{},{},{}\r\n", csv_field(fmt::format("{}", fmt::join(row.missing, "; "))),
            row.graded.when, csv_field(row.graded.marks ? row.graded.marks->grader : ""));
        for (const Student& student : row.students)
            text += fmt::format("{},{},{},{}", csv_field(student.id), csv_field(student.name),
                                csv_field(student.email), rest);
    });
    return text;
}

} // namespace raylab
