#include "app/course/prove_mistakes.h"

#include "app/course/in_a_cell.h"
#include "common/cli/progress.h"
#include "grader/course/contains.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::app {

namespace {

bool is_wrong(const CheckReport& report, const std::string& task) {
    return std::any_of(report.results.begin(), report.results.end(), [&](const TaskResult& result) {
        return result.task.id == task && result.verdict == TaskVerdict::wrong;
    });
}

MistakeProof prove(ProofBuild& build, const LabSources& lab, const Mistake& mistake) {
    // Its task, and those that it needs, in the lab's order as a student checks them: what is said
    // of a task begins with them.
    const std::vector<std::string>& needs = lab.sheet.find(mistake.task)->needs;
    std::vector<std::string> tasks = lab.sheet.task_ids();
    std::erase_if(
        tasks, [&](const std::string& id) { return id != mistake.task && !contains(needs, id); });
    CheckReport report = build.check(lab, {}, &mistake.change, tasks);
    // Where its task does not see it, does another?
    if (report.compiler_errors.empty() && !is_wrong(report, mistake.task))
        report = build.check(lab, {}, &mistake.change);
    if (!report.compiler_errors.empty())
        throw CourseError(fmt::format("{}: this mistake does not compile:\n{}",
                                      mistake.change.place, report.compiler_errors));
    MistakeProof proof{lab.sheet.number, mistake, false, false, "", {}, 0};
    proof.seconds = report.build_seconds + report.test_seconds;
    for (const TaskResult& result : report.results) {
        if (result.verdict != TaskVerdict::wrong) continue;
        if (result.task.id != mistake.task) {
            proof.others.push_back(result.task.id);
            continue;
        }
        proof.killed = true;
        proof.said = result.facts.empty() ? "" : result.facts.front();
        proof.named = mistake.is_named_by(proof.said);
    }
    return proof;
}

const char* verdict(const MistakeProof& proof) {
    return !proof.killed ? "PASSES" : proof.named ? "found" : "found, OTHER CAUSE";
}

int count(const std::vector<MistakeProof>& proofs, bool MistakeProof::*what) {
    return static_cast<int>(std::count_if(proofs.begin(), proofs.end(),
                                          [&](const MistakeProof& proof) { return proof.*what; }));
}

std::string sums(const std::vector<MistakeProof>& proofs) {
    return fmt::format("{} of {} mistakes found, {} by their cause",
                       count(proofs, &MistakeProof::killed), proofs.size(),
                       count(proofs, &MistakeProof::named));
}

} // namespace

std::vector<MistakeProof> prove_mistakes(ProofBuild& build, const LabSheet& sheet,
                                         const std::string& only) {
    const LabSources lab = read_lab_sources(sheet);
    std::vector<Mistake> mistakes = read_mistakes(sheet);
    std::erase_if(mistakes, [&](const Mistake& mistake) {
        return mistake.change.name.find(only) == std::string::npos;
    });
    std::vector<MistakeProof> proofs;
    Progress progress("planting in lab " + sheet.number, static_cast<int>(mistakes.size()),
                      "mistakes", 1);
    for (const Mistake& mistake : mistakes) {
        proofs.push_back(prove(build, lab, mistake));
        const MistakeProof& proof = proofs.back();
        progress.clear();
        fmt::print("{:18}  {}  {} ({:.1f} s)\n", verdict(proof), mistake.task, mistake.change.name,
                   proof.seconds);
        if (!proof.named && proof.killed) fmt::print("    said: {}\n", proof.said);
        if (!proof.killed && !proof.others.empty())
            fmt::print("    but found by {}\n", listed(proof.others));
        std::fflush(stdout);
        progress.update(static_cast<int>(proofs.size()));
    }
    return proofs;
}

std::string to_markdown(const std::vector<MistakeProof>& proofs) {
    std::string text = fmt::format(
        "# Known mistakes, and what `check` says of them\n\n"
        "Written by `./raylab prove --mistakes -o docs/mistakes.md`, which plants each mistake in "
        "the\n"
        "solution of its lab and checks its task and those that it needs; all tasks, where its own "
        "passes. {}.\n\n"
        "| task | mistake | verdict | the first thing that is said | also wrong | seconds |\n"
        "|---|---|---|---|---|--:|\n",
        sums(proofs));
    for (const MistakeProof& proof : proofs)
        text += fmt::format("| {} | {} | {} | {} | {} | {:.1f} |\n", proof.mistake.task,
                            in_a_cell(proof.mistake.change.title), verdict(proof),
                            in_a_cell(proof.said.substr(0, proof.said.find('\n'))),
                            fmt::join(proof.others, ", "), proof.seconds);
    return text;
}

ExitCode judged(const std::vector<MistakeProof>& proofs) {
    fmt::print("{}\n", sums(proofs));
    const int n = static_cast<int>(proofs.size());
    if (n == 0) throw CourseError("there is no mistake with this name: nothing was proved");
    const bool holds = count(proofs, &MistakeProof::killed) == n &&
                       10 * count(proofs, &MistakeProof::named) >= 9 * n;
    return holds ? ExitCode::success : ExitCode::judged_failed;
}

} // namespace raylab::app
