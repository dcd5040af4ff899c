// raylab grade-class LAB SUBMISSIONS -o DIR: marks of a class, resumable.
#include "app/class/commands.h"
#include "app/class/enter_class.h"
#include "common/cli/files.h"
#include "common/cli/folder_lock.h"
#include "common/cli/progress.h"
#include "common/load/suggest.h"
#include "grader/class/class_csv.h"
#include "grader/class/class_page.h"
#include "grader/class/differences.h"
#include "grader/class/item_analysis.h"
#include "grader/class/run_class.h"
#include "grader/class/similarity.h"
#include "grader/course/course_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <thread>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

struct ClassOptions {
    std::string lab, submissions, folder, only, grader, similarity;
    int jobs = 1;
    double limit = 1800;
    bool stage = false, differences = false, apply = false, drop = false, json = false;
};

std::optional<MarkVerdict> asked_verdict(const std::string& only) {
    if (only.empty()) return std::nullopt;
    if (const auto verdict = verdict_named(only)) return verdict;
    std::vector<std::string> known;
    for (const MarkVerdict verdict : all_verdicts()) known.emplace_back(name(verdict));
    throw CourseError(fmt::format("--only {}: there is no such verdict{}; the verdicts are {}",
                                  only, did_you_mean(only, known), listed(known)));
}

void grade(Journal& journal, Set set, const ClassOptions& options, const LabSheet& sheet,
           const std::string& grader) {
    const int waiting = journal.waiting(set);
    if (waiting == 0) return;
    const std::string program = options.grader.empty() ? grader : options.grader;
    if (!fs::exists(program))
        throw std::runtime_error(fmt::format("{} submissions wait, and '{}' is not there: name the "
                                             "program that grades with --grader",
                                             waiting, program));
    ClassGrader how;
    how.program = {fs::absolute(program).string(), "grade"};
    how.lab = sheet.folder;
    how.folder = fs::absolute(options.folder);
    how.jobs = options.jobs;
    how.limit_seconds = options.limit;
    Progress progress("grading", waiting, "submissions", 1);
    run_class(journal, set, how, [&progress](int done) { progress.update(done); });
}

void write_results(const Journal& journal, const LabSheet& sheet, const fs::path& folder) {
    write_file((folder / "marks.csv").string(), class_csv(journal, sheet));
    write_file((folder / "class.html").string(), class_page(journal, sheet, folder));
}

std::string to_json(const ClassFigures& figures, int staged) {
    nlohmann::ordered_json tasks = nlohmann::ordered_json::array();
    for (const TaskFigures& task : figures.tasks)
        tasks.push_back({{"id", task.id},
                         {"graded", task.graded},
                         {"passed", task.passed},
                         {"cause", task.cause},
                         {"named", task.named}});
    const nlohmann::ordered_json json = {{"submissions", figures.submissions},
                                         {"waiting", figures.waiting},
                                         {"refused", figures.refused},
                                         {"internal", figures.internal},
                                         {"staged", staged},
                                         {"median_score", figures.median_score()},
                                         {"tasks", tasks}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string to_text(const ClassFigures& figures, const LabSheet& sheet, const fs::path& folder) {
    std::string text;
    for (const TaskFigures& task : figures.tasks)
        text += fmt::format("{} {}: {} of {} passed{}\n", task.id, task.title, task.passed,
                            task.graded, task.cause.empty() ? "" : "; most often: " + task.cause);
    text += fmt::format(
        "lab {}: {} submissions, {} refused, {} with trouble of the grader's own, {} "
        "waiting\n{}\n{}\n",
        sheet.number, figures.submissions, figures.refused, figures.internal, figures.waiting,
        (folder / "marks.csv").string(), (folder / "class.html").string());
    if (figures.internal > 0)
        text += "grade those with trouble again: the same command with --only INTERNAL\n";
    return text;
}

// What changes the journal before anything is graded; false: then nothing is graded.
bool prepare(Journal& journal, const ClassOptions& options) {
    const std::optional<MarkVerdict> only = asked_verdict(options.only);
    if (options.drop) journal.drop_stage();
    if (options.apply) journal.apply_stage();
    if (options.drop || options.apply || options.differences || !options.similarity.empty())
        return false;
    if (options.stage)
        journal.begin_stage(only);
    else if (only)
        fmt::print(stderr, "{} submissions are graded again\n", journal.wait_again(*only));
    return true;
}

ExitCode run_grade_class(const fs::path& root, const std::string& grader,
                         const ClassOptions& options) {
    const LabSheet sheet = find_lab(root, options.lab);
    asked_verdict(options.only);
    const fs::path folder = options.folder;
    const FolderLock lock(folder);
    if (!lock.held())
        throw CourseError(
            fmt::format("another grader works in '{}': wait for its end, or name another "
                        "folder with -o",
                        options.folder));
    Journal journal(folder, sheet.folder);
    if (!options.submissions.empty()) {
        const EnteredClass entered = enter_class(options.submissions, sheet, folder, journal);
        fmt::print(stderr, "{} submissions ({}){}\n", entered.submissions, entered.layout,
                   entered.unused.empty() ? ""
                                          : fmt::format("; nobody's: {}", listed(entered.unused)));
    }
    tidy(journal, folder); // not before all is entered that an earlier attempt has unpacked
    if (prepare(journal, options))
        grade(journal, options.stage ? Set::staged : Set::live, options, sheet, grader);
    if (!options.similarity.empty()) {
        const int count =
            export_own_lines(journal, read_lab_sources(sheet), folder, options.similarity);
        fmt::print(stderr, "{}: what the students of {} submissions wrote themselves\n",
                   options.similarity, count);
    }
    tidy(journal, folder);
    if (options.stage || options.differences) fmt::print("{}", to_text(differences_of(journal)));
    const ClassFigures figures = figures_of(journal, sheet);
    write_results(journal, sheet, folder);
    if (options.json)
        fmt::print("{}\n", to_json(figures, journal.staged()));
    else if (!options.stage && !options.differences)
        fmt::print("{}", to_text(figures, sheet, folder));
    return figures.internal > 0 ? ExitCode::tool_failed : ExitCode::success;
}

} // namespace

Run add_grade_class(CLI::App& app, const fs::path& root, const std::string& grader) {
    auto options = std::make_shared<ClassOptions>();
    app.description("Mark the submissions of a class; go on after a kill at any moment.");
    app.add_option("LAB", options->lab, "lab: 01, 02, ... or its folder's name")->required();
    app.add_option("SUBMISSIONS", options->submissions,
                   "a folder or an archive, as Gradescope, Moodle, Canvas or Classroom 50 export "
                   "it, or with a "
                   "folder or an archive a student (default: those that are in DIR already)");
    app.add_option("-o,--output", options->folder,
                   "folder DIR of the class: its journal, marks and page")
        ->required();
    app.add_option("-j,--jobs", options->jobs, "submissions at a time")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    app.add_option(
        "--only", options->only,
        "grade again the submissions with this verdict, or with a task that has it: INTERNAL, "
        "TIME_LIMIT, ...");
    app.add_option("--limit", options->limit, "seconds for one submission")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    CLI::Option* stage =
        app.add_flag("--stage", options->stage,
                     "grade anew beside the marks that stand, all or those of --only");
    CLI::Option* differences =
        app.add_flag("--differences", options->differences, "show what the stage would change");
    CLI::Option* apply =
        app.add_flag("--apply", options->apply, "put the stage in the marks' place");
    CLI::Option* drop = app.add_flag("--drop", options->drop, "forget the stage");
    for (CLI::Option* one : {stage, differences, apply, drop})
        for (CLI::Option* other : {stage, differences, apply, drop})
            if (one != other) one->excludes(other);
    app.add_option(
        "--similarity", options->similarity,
        "write what the students wrote themselves, without what they were given, to an empty "
        "folder, a folder a submission, as JPlag and Dolos read it; nothing is graded");
    app.add_flag("--json", options->json, "print a JSON object");
    app.add_option(
        "--grader", options->grader,
        "program that grades one submission, called as PROGRAM grade LAB FOLDER -o DIR (default: "
        "this build's)");
    app.footer(
        "Examples:\n  raylab grade-class 02 submissions.zip -o out/lab02 --jobs 4\n"
        "  raylab grade-class 02 -o out/lab02                     goes on where it was killed\n"
        "  raylab grade-class 02 -o out/lab02 --only INTERNAL     those with the grader's own "
        "trouble, again\n"
        "  raylab grade-class 02 -o out/lab02 --stage             a regrade beside the marks\n"
        "  raylab grade-class 02 -o out/lab02 --differences       what it would change\n"
        "  raylab grade-class 02 -o out/lab02 --apply             or --drop\n"
        "DIR/marks.csv has a row a student, DIR/class.html a page with the item analysis.\n"
        "Exit code 0: all submissions have marks; 2: wrong usage or input; 3: the grader had "
        "trouble of\n"
        "its own, with some submissions (INTERNAL: no mark of theirs has changed) or altogether.");
    return [options, root, grader] { return run_grade_class(root, grader, *options); };
}

} // namespace raylab::app
