#include "grader/course/answers.h"

#include "common/cli/files.h"
#include "grader/course/release.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// The files of the tree in which each line stands.
using Places = std::map<std::string, std::set<std::string>>;

Answer answer_to(const Task& task, const LabSheet& lab, const SolutionLines& lines,
                 const Places& places, const fs::path& tree) {
    Answer answer{task.id, {}, 0, 0};
    for (const Withheld& withheld : lab.withhold)
        if (withheld.answers.contains(task.id) && fs::exists(tree / withheld.file))
            answer.files.insert(withheld.file);
    for (const auto& [line, tasks] : lines) {
        if (!tasks.contains(task.id)) continue;
        ++answer.of_lines;
        const auto found = places.find(line);
        if (found == places.end()) continue;
        ++answer.lines;
        answer.files.insert(found->second.begin(), found->second.end());
    }
    return answer;
}

} // namespace

SolutionLines solution_lines(const LabSources& lab) {
    SolutionLines lines;
    for (const MarkedSource& source : lab.files)
        for (const MarkedRegion* region : source.regions())
            for (const std::string& line : telling_lines(*region)) lines[line].insert(region->id);
    return lines;
}

std::vector<Answer> earlier_answers(const LabSheet& sheet, const fs::path& tree) {
    Places places;
    for_each_line(tree, [&](const std::string& file, int, const std::string& line) {
        if (const std::string code = squeezed(line); !code.empty()) places[code].insert(file);
    });
    std::vector<Answer> answers;
    for (const std::string& folder : lab_folders(sheet.root)) {
        const LabSheet lab = read_lab_sheet(sheet.root, folder);
        if (lab.number >= sheet.number) continue;
        const SolutionLines lines = solution_lines(read_lab_sources(lab));
        for (const Task& task : lab.tasks) {
            Answer answer = answer_to(task, lab, lines, places, tree);
            if (!answer.files.empty()) answers.push_back(std::move(answer));
        }
    }
    return answers;
}

std::string to_text(const std::vector<Answer>& answers) {
    std::string text;
    for (const Answer& answer : answers)
        text += fmt::format("    {}  {:2} of {:2} lines of its solution; {}\n", answer.task,
                            answer.lines, answer.of_lines, fmt::join(answer.files, ", "));
    return text;
}

} // namespace raylab
