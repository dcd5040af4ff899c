#include "grader/course/stub_tree.h"

#include "common/cli/files.h"
#include "common/load/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace raylab {

namespace fs = std::filesystem;

namespace {

bool is_source(const fs::path& file) {
    const std::string ending = file.extension().string();
    return ending == ".h" || ending == ".cpp" || ending == ".cu";
}

// The names of all files below a folder, relative to it, sorted.
std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
    std::sort(files.begin(), files.end());
    return files;
}

bool lists(const Task& task, const std::string& file) {
    return std::find(task.files.begin(), task.files.end(), file) != task.files.end();
}

void check_regions(const LabSheet& sheet, const MarkedSource& source, const std::string& file) {
    for (const MarkedRegion* region : source.regions()) {
        const std::string place = fmt::format("{}:{}", source.file, region->line);
        if (region->kind != MarkedRegion::Kind::task)
            throw CourseError(place + ": `withhold` is for files of common; a lab has tasks");
        const Task* task = sheet.find(region->id);
        if (!task)
            throw CourseError(fmt::format("{}: lab.json has no task {}{}", place, region->id,
                                          did_you_mean(region->id, sheet.task_ids())));
        if (!lists(*task, file))
            throw CourseError(fmt::format("{}: lab.json does not list {} among the files of "
                                          "task {}: add it there",
                                          place, file, region->id));
    }
}

// `check` refers students to a section of the handout, so the section must be there.
void check_hints(const LabSheet& sheet) {
    std::set<std::string> headings;
    std::istringstream handout(read_file((sheet.path() / "README.md").string()));
    for (std::string line; std::getline(handout, line);)
        if (line.starts_with('#') && line.find("# ") != line.npos)
            headings.insert(line.substr(line.find("# ") + 2));
    for (const Task& task : sheet.tasks)
        if (!headings.contains(task.hints))
            throw CourseError(fmt::format("labs/{}/README.md has no section \"{}\", but lab.json "
                                          "says that the hints of task {} are there",
                                          sheet.folder, task.hints, task.id));
}

} // namespace

const MarkedSource* LabSources::find(const std::string& file) const {
    const std::string name = "labs/" + sheet.folder + "/" + file;
    for (const MarkedSource& source : files)
        if (source.file == name) return &source;
    return nullptr;
}

LabSources read_lab_sources(const LabSheet& sheet) {
    check_hints(sheet);
    LabSources lab{sheet, {}};
    for (const fs::path& file : files_below(sheet.path())) {
        if (!is_source(file) || file.begin()->string() == "tests") continue;
        lab.files.push_back(parse_markers(read_file((sheet.path() / file).string()),
                                          "labs/" + sheet.folder + "/" + file.string()));
        check_regions(sheet, lab.files.back(), file.string());
    }
    for (const Task& task : sheet.tasks)
        for (const std::string& file : task.files) {
            const MarkedSource* source = lab.find(file);
            const auto regions = source ? source->regions() : std::vector<const MarkedRegion*>{};
            if (std::none_of(regions.begin(), regions.end(),
                             [&](const MarkedRegion* region) { return region->id == task.id; }))
                throw CourseError(fmt::format("labs/{0}/{1}:1: task {2} has no marker //[ task {2} "
                                              "here, but lab.json says so",
                                              sheet.folder, file, task.id));
        }
    return lab;
}

bool is_handed_out(const LabSheet& sheet, const fs::path& file) {
    const std::string first = file.begin()->string();
    if (first == "variations" || first == "mistakes" || first == "equivalent.json") return false;
    if (first != "tests") return true;
    return std::find(sheet.test_files.begin(), sheet.test_files.end(), file.string()) !=
           sheet.test_files.end();
}

void write_lab(const LabSources& lab, const std::set<std::string>& stubbed, const fs::path& root,
               const ChangeText& change) {
    const fs::path target = root / "labs" / lab.sheet.folder;
    for (const fs::path& file : files_below(lab.sheet.path())) {
        if (!is_handed_out(lab.sheet, file)) continue;
        const MarkedSource* source = lab.find(file.string());
        std::string text = source ? student_source(*source,
                                                   [&](const MarkedRegion& region) {
                                                       return stubbed.contains(region.id);
                                                   })
                                  : read_file((lab.sheet.path() / file).string());
        if (change) text = change(file.string(), std::move(text));
        write_if_changed(target / file, text);
    }
}

void write_if_changed(const fs::path& path, const std::string& bytes) {
    if (fs::is_regular_file(path) && read_file(path.string()) == bytes) return;
    fs::create_directories(path.parent_path());
    write_file(path.string(), bytes);
}

} // namespace raylab
