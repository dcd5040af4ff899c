// raylab prove: the tests of the labs' tasks are tested. For every task: red on its stub, green on
// the solution, green on every harmless variation; or, with --mistakes, red on every known mistake,
// and with --mutants on every slip.
#include "app/course/commands.h"
#include "app/course/proof_build.h"
#include "app/course/prove_mistakes.h"
#include "app/course/prove_mutants.h"
#include "common/cli/files.h"
#include "common/cli/progress.h"

#include <fmt/format.h>

#include <chrono>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

// One state of a lab's sources, and what its tests must report in this state.
struct State {
    std::string name;              // for people
    std::set<std::string> stubbed; // tasks
    const Variation* variation = nullptr;
};

struct TaskProof {
    Task task;
    bool stub_red = false, solution_green = false;
    int variations = 0, variations_green = 0;
    double check_seconds = 0; // build and tests of a lab in which this task was changed

    bool holds() const { return stub_red && solution_green && variations_green == variations; }
};

struct LabProof {
    LabSheet sheet;
    std::vector<TaskProof> tasks;
    std::vector<std::string> problems;
};

std::vector<State> states_of(const LabSheet& sheet, const std::vector<Variation>& variations) {
    std::vector<State> states = {{"the solution", {}}};
    for (const Task& task : sheet.tasks)
        states.push_back({"task " + task.id + " stubbed", {task.id}});
    const std::vector<std::string> all = sheet.task_ids();
    states.push_back({"all tasks stubbed", {all.begin(), all.end()}});
    for (const Variation& variation : variations)
        states.push_back({"variation " + variation.name, {}, &variation});
    return states;
}

// What is wrong with a verdict in a state, or "".
std::string objection(const State& state, const TaskResult& result) {
    const std::string& id = result.task.id;
    if (state.stubbed.contains(id)) {
        if (result.verdict != TaskVerdict::not_implemented)
            return fmt::format("is {} on its stub", name(result.verdict));
        const bool own = result.stubs.front().task == id;
        const bool placed = result.stubs.front().place.starts_with("labs/");
        return own && placed ? "" : "does not name its own stub";
    }
    if (result.verdict == TaskVerdict::pass) return "";
    // A test that calls a stubbed task cannot judge its own task, and reports the stub.
    if (result.verdict == TaskVerdict::waits && state.stubbed.contains(result.stubs.front().task))
        return "";
    return fmt::format("is {}{}{}", name(result.verdict), result.facts.empty() ? "" : ": ",
                       result.facts.empty() ? "" : result.facts.front());
}

void take(LabProof& proof, const State& state, const CheckReport& report) {
    if (!report.compiler_errors.empty()) {
        proof.problems.push_back(state.name + " does not compile:\n" + report.compiler_errors);
        return;
    }
    for (std::size_t i = 0; i < report.results.size(); ++i) {
        TaskProof& task = proof.tasks[i];
        const std::string wrong = objection(state, report.results[i]);
        if (!wrong.empty())
            proof.problems.push_back(
                fmt::format("{}: task {} {}", state.name, task.task.id, wrong));
        if (state.variation)
            task.variations_green += wrong.empty();
        else if (state.stubbed.empty())
            task.solution_green = wrong.empty();
        else if (state.stubbed == std::set{task.task.id}) {
            task.stub_red = wrong.empty();
            task.check_seconds = report.build_seconds + report.test_seconds;
        }
    }
}

LabProof prove_lab(ProofBuild& build, const LabSheet& sheet) {
    const LabSources lab = read_lab_sources(sheet);
    const std::vector<Variation> variations = read_variations(sheet);
    LabProof proof{sheet, {}, {}};
    for (const Task& task : sheet.tasks)
        proof.tasks.push_back({task, false, false, static_cast<int>(variations.size()), 0, 0});

    const std::vector<State> states = states_of(sheet, variations);
    Progress progress("proving lab " + sheet.number, static_cast<int>(states.size()), "states", 1);
    int done = 0;
    for (const State& state : states) {
        take(proof, state, build.check(lab, state.stubbed, state.variation));
        progress.update(++done);
    }
    return proof;
}

std::string to_markdown(const std::vector<LabProof>& proofs) {
    std::string text =
        "# The tasks, and the proof of their tests\n\n"
        "Written by `./raylab prove -o docs/tasks.md`, which builds every lab with each task\n"
        "stubbed, with all stubbed, as its solution and in every variation of it that is right\n"
        "too. Stub red: `raylab check` says NOT IMPLEMENTED with task, function and place, and no\n"
        "other task is called wrong for it. Seconds: build and tests after a change to the task's\n"
        "files, at -O1 and with one variant of each kernel, as on the machine of the last run.\n";
    for (const LabProof& proof : proofs) {
        text += fmt::format("\n## {}: {}\n\n"
                            "| task | title | points | minutes | stub | solution | variations | "
                            "seconds |\n|---|---|--:|--:|---|---|---|--:|\n",
                            proof.sheet.folder, proof.sheet.title);
        for (const TaskProof& task : proof.tasks)
            text += fmt::format("| {} | {} | {} | {} | {} | {} | {} of {} green | {:.1f} |\n",
                                task.task.id, task.task.title, task.task.points, task.task.minutes,
                                task.stub_red ? "red" : "NOT RED",
                                task.solution_green ? "green" : "NOT GREEN", task.variations_green,
                                task.variations, task.check_seconds);
        text += "\nVariations:\n\n";
        for (const Variation& variation : read_variations(proof.sheet))
            text += fmt::format("- {} (`{}`)\n", variation.title, variation.file);
    }
    return text;
}

struct ProveOptions {
    std::vector<std::string> labs;
    std::string output, only;
    bool mistakes = false, mutants = false;
    int every = 1; // of the mutants
};

// The labs' mistakes or mutants: judged, and written as a table. `prove` gives what one lab has.
template <class Prove>
ExitCode prove_planted(const Tree& tree, const std::vector<std::string>& labs,
                       const std::string& output, const Prove& prove) {
    decltype(prove(find_lab(tree.root, labs.front()))) proofs;
    for (const std::string& lab : labs)
        for (auto& proof : prove(find_lab(tree.root, lab))) proofs.push_back(std::move(proof));
    if (!output.empty()) write_file(output, to_markdown(proofs));
    return judged(proofs);
}

ExitCode run_prove(const Tree& tree, const ProveOptions& options) {
    if (!options.output.empty()) prepare_output(options.output);
    std::vector<std::string> labs = options.labs;
    if (labs.empty()) labs = lab_folders(tree.root);
    if (labs.empty())
        throw std::runtime_error(
            fmt::format("{} has no lab: nothing was proved", tree.root.string()));
    ProofBuild build(tree);
    if (options.mistakes)
        return prove_planted(tree, labs, options.output, [&](const LabSheet& sheet) {
            return prove_mistakes(build, sheet, options.only);
        });
    if (options.mutants)
        return prove_planted(tree, labs, options.output, [&](const LabSheet& sheet) {
            return prove_mutants(build, sheet, {options.only, options.every});
        });
    std::vector<LabProof> proofs;
    bool holds = true;
    for (const std::string& lab : labs) {
        proofs.push_back(prove_lab(build, find_lab(tree.root, lab)));
        const LabProof& proof = proofs.back();
        for (const TaskProof& task : proof.tasks) {
            holds = holds && task.holds();
            fmt::print("{:5} {}  {}: stub {}, solution {}, {} of {} variations green, {:.1f} s\n",
                       task.holds() ? "ok" : "WRONG", task.task.id, task.task.title,
                       task.stub_red ? "red" : "NOT RED",
                       task.solution_green ? "green" : "NOT GREEN", task.variations_green,
                       task.variations, task.check_seconds);
        }
        for (const std::string& problem : proof.problems) fmt::print("      {}\n", problem);
        holds = holds && proof.problems.empty();
    }
    if (!options.output.empty()) write_file(options.output, to_markdown(proofs));
    return holds ? ExitCode::success : ExitCode::judged_failed;
}

} // namespace

Run add_prove(CLI::App& app, const Tree& tree) {
    auto options = std::make_shared<ProveOptions>();
    app.description("Prove the tests of the tasks: red on each stub, green on the solution and on "
                    "every harmless variation.");
    app.add_option("LABS", options->labs, "labs (default: all)");
    auto* mistakes = app.add_flag("--mistakes", options->mistakes,
                                  "instead: red on every known mistake, for the right cause");
    auto* mutants = app.add_flag("--mutants", options->mutants,
                                 "instead: red on the solution with a slip of the hand in it, for "
                                 "each slip in each task's lines; hours for all labs")
                        ->excludes(mistakes);
    app.add_option(
        "--only", options->only,
        "the mistakes with this in their name, the mutants with it in their file or kind");
    app.add_option("--every", options->every, "of the mutants one in so many")
        ->needs(mutants)
        ->check(CLI::PositiveNumber);
    app.add_option("-o,--output", options->output, "write the table as Markdown");
    app.footer(
        "Examples:\n  raylab prove 02\n  raylab prove -o docs/tasks.md\n"
        "  raylab prove --mistakes -o docs/mistakes.md\n"
        "  raylab prove 03 --mistakes --only scan\n"
        "  raylab prove --mutants --every 40 -o docs/mutants.md\n"
        "Exit code 1: a test is green on a stub, or red on a right solution; a mistake passes, "
        "or fewer\nthan nine in ten are called by their cause; a mutant survives that "
        "labs/*/equivalent.json does\nnot list.");
    return [options, tree] {
        if (!options->only.empty() && !options->mistakes && !options->mutants)
            throw CourseError("--only is for --mistakes and --mutants");
        return run_prove(tree, *options);
    };
}

} // namespace raylab::app
