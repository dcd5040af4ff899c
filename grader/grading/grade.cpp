#include "grader/grading/grade.h"
#include "grader/course/blank_marks.h"

#include "common/cli/files.h"
#include "common/load/load.h"
#include "grader/course/contains.h"
#include "grader/course/needs_first.h"
#include "grader/course/stub_tree.h"
#include "grader/course/verdict.h"
#include "grader/grading/base_build.h"
#include "grader/grading/hidden_scene.h"
#include "grader/grading/marks_of.h"
#include "grader/grading/object_check.h"
#include "grader/grading/submission_build.h"
#include "grader/grading/test_runs.h"
#include "grader/submissions/submission.h"

#include <fmt/format.h>

#include <chrono>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

// A folder of one's own below /tmp, removed at the end.
class Scratch {
  public:
    Scratch() : path_((fs::temp_directory_path() / "raylab-grade-XXXXXX").string()) {
        if (mkdtemp(path_.data()) == nullptr)
            throw std::system_error(errno, std::generic_category(), path_);
        fs::permissions(path_,
                        fs::perms(0755)); // the sandbox's user reads programs and scenes in it
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    fs::path operator/(const std::string& name) const { return fs::path(path_) / name; }

  private:
    std::string path_;
};

constexpr double patience = 1. / 3; // of a test: 10 s, where the labs' own take milliseconds
constexpr std::uint64_t program_bytes = 256ull << 20;

// A program that the compiler left in the sandbox, copied to where nobody of the sandbox can write.
fs::path take_program(const fs::path& from, const fs::path& to) {
    const sandbox::OutputFile file =
        sandbox::read_output(from.parent_path(), from.filename().string(), program_bytes);
    if (!file.trouble.empty()) throw std::runtime_error("after the build: " + file.trouble);
    write_file(to.string(), file.bytes);
    fs::permissions(to, fs::perms(0755));
    return to;
}

// The names that the students' tree and the solution have in their objects: the solution is built
// as a submission is.
void note_allowed_symbols(const LabSheet& solution, const BaseBuild& base,
                          const sandbox::Isolation& isolation) {
    Scratch scratch;
    const fs::path root = scratch / "solution";
    write_lab(read_lab_sources(solution), {}, root);
    SubmissionBuild build(base, root / "labs" / solution.folder, solution.files(), isolation);
    if (!build.build().succeeded())
        throw std::runtime_error(fmt::format("the solution does not build in the sandbox, {}:\n{}",
                                             sandbox::why(build.build(), SubmissionBuild::limits()),
                                             build.compiler_errors()));
    const std::vector<std::string> objects = build.changed_objects();
    const ObjectSymbols allowed =
        allowed_by(read_symbols(base.build(), objects, isolation),
                   read_symbols(build.build_folder(), objects, isolation));
    write_file((base.folder / "symbols").string(), to_text(allowed));
}

class Grading {
  public:
    Grading(const GradeOptions& options, const std::function<void(const Graded&)>& so_far)
        : options_(options), so_far_(so_far) {
        graded_.marks = blank_marks(options.sheet, options.sheet.task_ids(), "raylab grade");
        graded_.marks.sandbox = options.isolation.sentence();
    }
    Graded operator()();

  private:
    bool compiles(SubmissionBuild& build, const BaseBuild& base);
    void test(const SubmissionBuild& build, const BaseBuild& base);
    void draw_all(const Submission& submission, const BaseBuild& base);
    void draw(const GradedPicture& picture, const fs::path& scene, const fs::path& assets,
              bool hidden);
    void tell() {
        graded_.marks.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        so_far_(graded_);
    }

    const GradeOptions& options_;
    const std::function<void(const Graded&)>& so_far_;
    Graded graded_;
    Scratch scratch_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// False: no task can be tested, and the marks say why.
bool Grading::compiles(SubmissionBuild& build, const BaseBuild& base) {
    const sandbox::Outcome& outcome = build.build();
    if (outcome.end == sandbox::End::not_started)
        throw std::runtime_error("the compiler could not be started in the sandbox: " +
                                 outcome.trouble);
    if (!outcome.succeeded()) {
        mark_unbuilt(graded_.marks, outcome, build.compiler_errors(), SubmissionBuild::limits());
        return false;
    }
    const std::vector<std::string> objects = build.changed_objects();
    const ObjectSymbols allowed = symbols_of_text(read_file((base.folder / "symbols").string()));
    std::string suspicion =
        first_suspicion(read_symbols(build.build_folder(), objects, options_.isolation), allowed,
                        options_.sheet.number);
    if (suspicion.empty() && calls_the_kernel(build.build_folder(), objects, options_.isolation))
        suspicion = "an instruction calls the kernel by itself";
    if (suspicion.empty()) return true;
    mark_all(graded_.marks, MarkVerdict::suspicious,
             "a task has no reason for this: " + suspicion +
                 "; nothing was run, a person has to look at it");
    return false;
}

void Grading::test(const SubmissionBuild& build, const BaseBuild& base) {
    const fs::path tests =
        take_program(build.build_folder() / "labs" / base.sheet.folder / base.sheet.test_target,
                     scratch_ / "tests");
    take_program(build.build_folder() / draw_program(), scratch_ / "draw");
    const LabSheet sheet = build.sheet();
    const SubmittedTests program(base.tests(), tests, options_.isolation);
    std::vector<TaskResult> results;
    for (const Task& task : sheet.tasks) {
        program.forget();
        results.push_back(judge_task(sheet, task, program, patience));
        mark_task(graded_.marks, results.back(), program.bad_end(), program.forged());
        tell();
    }
    say_what_is_needed_first(results);
    for (const TaskResult& result : results) set_reasons(graded_.marks, result);
}

void Grading::draw(const GradedPicture& picture, const fs::path& scene, const fs::path& assets,
                   bool hidden) {
    JudgedPicture judged{picture, hidden, false, {}};
    judged.drawn = all_pass(graded_.marks, picture.tasks);
    if (judged.drawn) {
        judged.result = judge_picture(SubmittedDrawing{scratch_ / "draw",
                                                       options_.sheet.number,
                                                       scene,
                                                       {assets / "meshes", assets / "textures"},
                                                       picture.options,
                                                       &options_.isolation},
                                      SolutionDrawing{options_.draw, options_.sheet.number, scene});
        mark_picture(graded_.marks, judged);
    }
    graded_.pictures.push_back(std::move(judged));
    tell();
}

void Grading::draw_all(const Submission& submission, const BaseBuild& base) {
    const std::string key = read_key(options_.key);
    const fs::path assets = base.tree() / "scenes"; // not its references
    int number = 0;
    for (const GradedPicture& picture : options_.sheet.pictures) {
        const fs::path bundled = find_scene(picture.scene);
        const std::string text = read_file(bundled.string());
        const fs::path scene = scratch_ / fmt::format("scene{}.json", ++number);
        write_file(scene.string(), public_scene(text, assets, picture.roulette));
        draw(picture, scene, assets, false);
        // Without a sandbox a program could read the reference while it is made.
        if (options_.isolation.tier == sandbox::Tier::limited) continue;
        Derived numbers(key, submission.hash + "/" + options_.sheet.folder + "/" + picture.scene);
        const fs::path unseen = scratch_ / fmt::format("scene{}.json", ++number);
        write_file(unseen.string(), hidden_scene(text, assets, picture.roulette, numbers));
        draw(picture, unseen, assets, true);
    }
}

Graded Grading::operator()() {
    const Submission submission =
        unpack_submission(options_.submission, options_.sheet, scratch_ / "submission");
    if (submission.files.empty())
        throw SubmissionError(fmt::format("'{}' has no file of lab {}: expected one of {}",
                                          options_.submission.string(), options_.sheet.number,
                                          fmt::join(options_.sheet.files(), ", ")));
    graded_.marks.missing = submission.missing;
    graded_.marks.ignored = submission.ignored;
    tell();
    const BaseBuild base = prepare_base(
        options_.sheet, options_.cache, options_.isolation, [&](const BaseBuild& built) {
            note_allowed_symbols(options_.sheet, built, options_.isolation);
        });
    start_ = std::chrono::steady_clock::now();
    SubmissionBuild build(base, submission.folder, submission.files, options_.isolation);
    if (compiles(build, base)) {
        test(build, base);
        draw_all(submission, base);
    }
    tell();
    return std::move(graded_);
}

} // namespace

Graded grade(const GradeOptions& options, const std::function<void(const Graded&)>& so_far) {
    return Grading(options, so_far)();
}

} // namespace raylab::grading
