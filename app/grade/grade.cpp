// raylab grade LAB SUBMISSION -o DIR: marks of one submission, which is built and run in a sandbox.
#include "grader/grading/grade.h"
#include "app/grade/commands.h"
#include "app/grade/grade_report.h"
#include "common/cli/files.h"
#include "grader/course/blank_marks.h"
#include "grader/results/formats.h"
#include "grader/results/mark_files.h"
#include "grader/results/marks_json.h"
#include "grader/submissions/submission_error.h"

#include <fmt/format.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

struct Options {
    std::string lab, submission, folder, key;
    std::vector<std::string> writes; // FORMAT:FILE
    int tier = 0;
    bool json = false;
};

// marks.json in the folder, and the files of platforms, again after each step: a platform that ends
// the process finds what was known until then.
void write_all(const Options& options, const MarkFiles& files, const Marks& marks) {
    write_file((fs::path(options.folder) / "marks.json").string(), marks_json(marks));
    files.write(marks);
}

void print(const Marks& marks) {
    for (const std::string& file : marks.missing) fmt::print("missing: {}\n", file);
    for (const std::string& file : marks.ignored) fmt::print("not used: {}\n", file);
    for (const Mark& mark : marks.tasks) {
        fmt::print("{:15}  {}  {} ({}/{} points)\n", name(mark.verdict), mark.id, mark.title,
                   mark.points(), mark.of_points);
        for (const std::string& reason : mark.reasons) fmt::print("    {}\n", reason);
    }
    fmt::print("{} of {} points in {:.1f} s; {}\n", marks.points(), marks.of_points(),
               marks.seconds, marks.sandbox);
}

sandbox::Isolation isolation(const Options& options) {
    return options.tier == 0 ? sandbox::best_isolation()
                             : sandbox::isolation_of(static_cast<sandbox::Tier>(options.tier));
}

ExitCode run_grade(const GraderTree& tree, const Options& options) {
    const MarkFiles files(options.writes);
    const LabSheet sheet = find_lab(tree.root, options.lab);
    if (!fs::exists(options.submission))
        throw SubmissionError(fmt::format("there is no submission '{}'", options.submission));
    prepare_output((fs::path(options.folder) / "marks.json").string());
    grading::Graded graded;
    graded.marks = blank_marks(sheet, sheet.task_ids(), "raylab grade");
    const auto in_trouble = [&](const std::string& trouble) {
        graded.marks.trouble = trouble;
        write_all(options, files, graded.marks);
        graded.marks.trouble.clear();
    };
    in_trouble("the grader was stopped before it was done");
    try {
        graded = grading::grade({sheet, options.submission, tree.cache(),
                                 options.key.empty() ? tree.cache() / "key" : fs::path(options.key),
                                 tree.draw, isolation(options)},
                                [&](const grading::Graded& so_far) {
                                    graded.marks = so_far.marks;
                                    in_trouble("the grader was stopped before it was done");
                                });
    } catch (const SubmissionError& error) {
        in_trouble(error.what());
        throw;
    } catch (const std::exception& error) {
        in_trouble(error.what());
        throw std::runtime_error(
            fmt::format("INTERNAL: {}; nothing is said about the submission", error.what()));
    }
    write_all(options, files, graded.marks);
    if (!graded.pictures.empty()) write_grade_report(graded, options.folder);
    if (!graded.marks.log.empty())
        write_file((fs::path(options.folder) / "log.txt").string(), graded.marks.log);
    if (options.json)
        fmt::print("{}\n", marks_json(graded.marks));
    else
        print(graded.marks);
    return graded.marks.passed() ? ExitCode::success : ExitCode::judged_failed;
}

} // namespace

Run add_grade(CLI::App& app, const GraderTree& tree) {
    auto options = std::make_shared<Options>();
    app.description("Grade a submission: build and run it in a sandbox, judge what it draws.");
    app.add_option("LAB", options->lab, "lab: 01, 02, ... or its folder's name")->required();
    app.add_option("SUBMISSION", options->submission, "folder, archive or file")->required();
    app.add_option("-o,--output", options->folder, "folder for marks.json and report.html")
        ->required();
    app.add_flag("--json", options->json, "print marks.json instead of the table");
    app.add_option("--write", options->writes,
                   "FORMAT:FILE, a file of marks, may be given again; formats: " +
                       fmt::format("{}", fmt::join(mark_formats(), ", ")))
        ->allow_extra_args(false);
    app.add_option("--key", options->key,
                   "file of the key that hidden scenes follow from (default: one of this tree)");
    app.add_option("--tier", options->tier, "a weaker sandbox than the best that works here")
        ->check(CLI::Range(1, 3));
    app.footer("Examples:\n  raylab grade 02 submissions/ada -o out/ada\n"
               "  raylab grade 02 submission.zip -o out/marks --write gradescope:results.json\n"
               "Exit code 0: all points; 1: not all; 2: no submission, or wrong usage;\n"
               "3: the grader's own trouble, and nothing is said about the submission.");
    return [options, tree] { return run_grade(tree, *options); };
}

} // namespace raylab::app
