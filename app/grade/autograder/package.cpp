#include "app/grade/autograder/package.h"

#include "common/cli/files.h"
#include "common/cli/process.h"
#include "grader/course/blank_marks.h"
#include "grader/grading/grade.h"
#include "grader/grading/secret.h"
#include "grader/results/formats.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>
#include <sstream>
#include <unistd.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

using Words = std::map<std::string, std::string>; // by the word in a template, "@LAB@"

// Debian's names in packages.txt, as the script `raylab` reads them.
std::vector<std::string> debian_packages(const fs::path& root) {
    std::vector<std::string> names;
    std::istringstream lines(read_file((root / "packages.txt").string()));
    for (std::string line; std::getline(lines, line);)
        if (const std::string name = line.substr(0, line.find_first_of("# ")); !name.empty())
            names.push_back(name);
    return names;
}

// What students send: the lab's files by name, or an archive where a platform takes no folders.
std::string upload_of(const LabSheet& sheet) {
    const std::vector<std::string> files = sheet.files();
    for (const std::string& file : files)
        if (file.find('/') != file.npos) return "submission.zip";
    return fmt::format("{}", fmt::join(files, ", "));
}

std::string random_uuid() {
    const std::string hex = grading::random_hex(16);
    return fmt::format("{}-{}-4{}-a{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(13, 3),
                       hex.substr(17, 3), hex.substr(20, 12));
}

Words words_of(const Platform& platform, const LabSheet& sheet) {
    int points = 0;
    for (const Task& task : sheet.tasks) points += task.points;
    nlohmann::json files = nlohmann::json::array();
    for (const std::string& file : sheet.files())
        files.push_back("labs/" + sheet.folder + "/" + file);
    return {{"@LAB@", sheet.number},
            {"@FOLDER@", sheet.folder},
            {"@TITLE@", sheet.title},
            {"@POINTS@", std::to_string(points)},
            {"@UPLOAD@", upload_of(sheet)},
            {"@FILES@", files.dump()},
            {"@PACKAGES@", nlohmann::json(debian_packages(sheet.root)).dump()},
            {"@UUID@", random_uuid()},
            {"@PLATFORM@", platform.title},
            {"@FORMAT@", platform.format},
            {"@RUN@", platform.run},
            {"@ROOT@", platform.root},
            {"@SUBMISSION@", platform.submission},
            {"@SOURCE@", platform.source},
            {"@LIMIT@", std::to_string(platform.limit_seconds)}};
}

std::string filled_in(std::string text, const Words& words) {
    for (const auto& [word, value] : words)
        for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; at += value.size())
            text.replace(at, word.size(), value);
    return text;
}

// All that a grader is built from. GNU's format keeps whole seconds of times, which every image
// keeps, too: the times of sources say whether a build is still of use.
void pack_tree(const fs::path& root, const fs::path& archive) {
    const ProcessResult result = run_process({"tar",
                                              "-C",
                                              root.string(),
                                              "--format=gnu",
                                              "--sort=name",
                                              "--owner=0",
                                              "--group=0",
                                              "--numeric-owner",
                                              "--exclude=__pycache__",
                                              "-czf",
                                              archive.string(),
                                              "CMakeLists.txt",
                                              "CMakePresets.json",
                                              "LICENSE",
                                              "packages.txt",
                                              "raylab",
                                              "app",
                                              "cmake",
                                              "common",
                                              "docs",
                                              "grader",
                                              "labs",
                                              "scenes"},
                                             {300});
    if (!result.succeeded())
        throw std::runtime_error(
            fmt::format("the tree {} could not be packed: {}", root.string(), why_failed(result)));
}

// What the platform sees until the grader has written its first result.
std::string nothing_yet(const Platform& platform, const LabSheet& sheet) {
    Marks marks = blank_marks(sheet, sheet.task_ids(), "raylab grade");
    marks.trouble = "the grader came to no result; please tell your instructors";
    return write_marks(platform.format, marks);
}

void write_files(const Platform& platform, const LabSheet& sheet, const fs::path& folder) {
    const fs::path templates = sheet.root / "app/grade/autograder";
    const Words words = words_of(platform, sheet);
    for (const PackageFile& file : platform.files) {
        const fs::path place = folder / file.name;
        fs::create_directories(place.parent_path());
        write_file(place.string(),
                   filled_in(read_file((templates / file.made_of).string()), words));
        if (file.executable)
            fs::permissions(place, fs::perms::owner_all | fs::perms::group_read |
                                       fs::perms::group_exec | fs::perms::others_read |
                                       fs::perms::others_exec);
    }
    if (!platform.grades()) return;
    const fs::path secrets = folder / platform.secrets;
    pack_tree(sheet.root, secrets / "raylab.tar.gz");
    write_file((secrets / "internal.json").string(), nothing_yet(platform, sheet));
    grading::read_key(secrets / "key"); // makes it
}

} // namespace

void write_package(const Platform& platform, const LabSheet& sheet, const fs::path& folder) {
    const fs::path target = fs::absolute(folder).lexically_normal();
    if (fs::exists(target) && !(fs::is_directory(target) && fs::is_empty(target)))
        throw FileError(fmt::format("'{}' is there already: name another folder, or remove it",
                                    folder.string()),
                        ExitCode::bad_usage);
    const fs::path place = target.has_filename() ? target : target.parent_path();
    const fs::path part = place.string() + fmt::format(".part-{}", getpid());
    fs::create_directories(part);
    try {
        fs::permissions(part, fs::perms::owner_all);
        write_files(platform, sheet, part);
        fs::rename(part, place);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(part, ignored);
        throw;
    }
}

} // namespace raylab::app
