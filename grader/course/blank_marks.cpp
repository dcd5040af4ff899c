#include "grader/course/blank_marks.h"

#include <fmt/format.h>

namespace raylab {

Marks blank_marks(const LabSheet& sheet, const std::vector<std::string>& ids,
                  const std::string& grader) {
    Marks marks;
    marks.lab = sheet.folder;
    marks.title = sheet.title;
    marks.grader = grader;
    for (const std::string& id : ids) {
        const Task& task = *sheet.find(id);
        Mark mark;
        mark.id = task.id;
        mark.title = task.title;
        mark.of_points = task.points;
        if (!task.files.empty())
            mark.file = fmt::format("labs/{}/{}", sheet.folder, task.files.front());
        mark.read_on = task.hints;
        marks.tasks.push_back(mark);
    }
    return marks;
}

} // namespace raylab
