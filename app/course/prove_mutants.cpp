#include "app/course/prove_mutants.h"

#include "app/course/in_a_cell.h"
#include "common/cli/progress.h"
#include "grader/course/code_edits.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::app {

namespace {

// The tasks of these that are WRONG with the mutant planted.
void check(ProofBuild& build, const LabSources& lab, const std::vector<std::string>& tasks,
           MutantProof& proof) {
    const CheckReport report = build.check(lab, {}, nullptr, tasks);
    proof.seconds += report.build_seconds + report.test_seconds;
    if (!report.compiler_errors.empty()) {
        proof.fate = Fate::does_not_compile;
        return;
    }
    for (const TaskResult& result : report.results)
        if (result.verdict == TaskVerdict::wrong) proof.killers.push_back(result.task.id);
    if (!proof.killers.empty()) proof.fate = Fate::killed;
}

MutantProof prove(ProofBuild& build, const LabSources& lab, const Mutant& mutant,
                  const MutantSample& sample) {
    MutantProof proof{lab.sheet.folder, mutant, Fate::survives, {}, 0, sample};
    if (mutant.why_equivalent) {
        proof.fate = Fate::equivalent;
        return proof;
    }
    const LabSources with = planted(lab, mutant);
    std::vector<std::string> others;
    for (const Task& task : lab.sheet.tasks)
        if (task.id != mutant.task) others.push_back(task.id);
    check(build, with, {mutant.task}, proof);
    // Where its own task does not see it, does another?
    if (proof.fate == Fate::survives && !others.empty()) check(build, with, others, proof);
    return proof;
}

std::string name(const MutantProof& proof) {
    switch (proof.fate) {
    case Fate::killed:
        return fmt::format("killed by {}", fmt::join(proof.killers, ", "));
    case Fate::survives:
        return "SURVIVES";
    case Fate::equivalent:
        return "equivalent";
    case Fate::does_not_compile:
        return "does not compile";
    }
    return "";
}

std::string change(const MutantProof& proof) {
    return fmt::format("{}:{}: {} -> {}", proof.mutant.file, proof.mutant.line, proof.mutant.was,
                       proof.mutant.is);
}

struct Sums {
    int planted = 0, killed = 0, survive = 0, equivalent = 0, no_code = 0;
    void add(const MutantProof& proof) {
        ++planted;
        killed += proof.fate == Fate::killed;
        survive += proof.fate == Fate::survives;
        equivalent += proof.fate == Fate::equivalent;
        no_code += proof.fate == Fate::does_not_compile;
    }
    // Of those that differ from the solution, and that a compiler takes.
    double killed_share() const {
        return killed + survive == 0 ? 1 : double(killed) / (killed + survive);
    }
    std::string row(const std::string& what) const {
        return fmt::format("| {} | {} | {} | {} | {} | {} | {:.1f} % |\n", what, planted, no_code,
                           equivalent, killed, survive, 100 * killed_share());
    }
};

template <class Key>
std::string rows(const std::vector<MutantProof>& proofs, const std::vector<std::string>& keys,
                 const Key& key) {
    std::string text;
    for (const std::string& one : keys) {
        Sums sums;
        for (const MutantProof& proof : proofs)
            if (key(proof) == one) sums.add(proof);
        if (sums.planted > 0) text += sums.row(one);
    }
    return text;
}

std::vector<std::string> labs_of(const std::vector<MutantProof>& proofs) {
    std::vector<std::string> labs;
    for (const MutantProof& proof : proofs)
        if (labs.empty() || labs.back() != proof.lab) labs.push_back(proof.lab);
    return labs;
}

Sums sums_of(const std::vector<MutantProof>& proofs) {
    Sums sums;
    for (const MutantProof& proof : proofs) sums.add(proof);
    return sums;
}

std::string table_of(const std::vector<MutantProof>& proofs, Fate fate, const std::string& last) {
    std::string text;
    for (const MutantProof& proof : proofs)
        if (proof.fate == fate)
            text += fmt::format(
                "| {} | {}/{}:{} | {} | `{}` | `{}` |{}\n", proof.mutant.task, proof.lab,
                proof.mutant.file, proof.mutant.line, proof.mutant.kind,
                in_a_cell(proof.mutant.was), in_a_cell(proof.mutant.is),
                last.empty() ? "" : " " + in_a_cell(*proof.mutant.why_equivalent) + " |");
    if (text.empty()) return "None.\n";
    return fmt::format("| task | place | slip | solution | mutant |{}\n|---|---|---|---|---|{}\n{}",
                       last.empty() ? "" : " " + last + " |", last.empty() ? "" : "---|", text);
}

} // namespace

std::vector<MutantProof> prove_mutants(ProofBuild& build, const LabSheet& sheet,
                                       const MutantSample& sample) {
    const LabSources lab = read_lab_sources(sheet);
    std::vector<Mutant> mutants;
    int number = 0;
    for (Mutant& mutant : mutants_of(lab))
        if ((mutant.file + " " + mutant.kind).find(sample.only) != std::string::npos &&
            number++ % sample.every == 0)
            mutants.push_back(std::move(mutant));
    fmt::print("lab {}: {} of {} mutants\n", sheet.number, mutants.size(), number);
    std::vector<MutantProof> proofs;
    Progress progress("planting in lab " + sheet.number, static_cast<int>(mutants.size()),
                      "mutants", 1);
    for (const Mutant& mutant : mutants) {
        proofs.push_back(prove(build, lab, mutant, sample));
        progress.clear();
        fmt::print("{}  {} ({:.1f} s)\n    {}\n", mutant.task, name(proofs.back()),
                   proofs.back().seconds, change(proofs.back()));
        std::fflush(stdout);
        progress.update(static_cast<int>(proofs.size()));
    }
    return proofs;
}

std::string to_markdown(const std::vector<MutantProof>& proofs) {
    const MutantSample sample = proofs.empty() ? MutantSample{} : proofs.front().sample;
    const std::string options = (sample.only.empty() ? "" : " --only " + sample.only) +
                                (sample.every == 1 ? "" : fmt::format(" --every {}", sample.every));
    const std::string head =
        "| planted | do not compile | equivalent | killed | survive | killed, of "
        "those that could be |\n|---|--:|--:|--:|--:|--:|--:|\n";
    return fmt::format(
        "# Mutants of the solutions, and the tests that fail on them\n\n"
        "Written by `./raylab prove --mutants{} -o docs/mutants.md`, which makes one slip of the "
        "hand\n"
        "in the lines between a task's markers, builds the lab, and runs the tests of the task; "
        "those of\n"
        "all other tasks, where its own pass. {} A mutant is *killed* if a test fails, and "
        "*equivalent* if\n"
        "`labs/NN_name/equivalent.json` says why it does the same as the solution. Tests run with "
        "the CUDA\n"
        "threads in two orders, without the watch.\n\n"
        "| lab {}{}{}"
        "\n## By kind\n\n| slip {}{}\n## Survivors\n\n{}\n## Equivalent\n\n{}",
        options,
        options.empty()
            ? "All mutants were planted."
            : fmt::format("This is a sample: {}{}.",
                          sample.every == 1 ? "all" : fmt::format("one in {}", sample.every),
                          sample.only.empty()
                              ? ", in the order of files and lines"
                              : fmt::format(" with \"{}\" in file or kind", sample.only)),
        head, rows(proofs, labs_of(proofs), [](const MutantProof& p) { return p.lab; }),
        sums_of(proofs).row("**all**"), head,
        rows(proofs, mutation_kinds(), [](const MutantProof& p) { return p.mutant.kind; }),
        table_of(proofs, Fate::survives, ""), table_of(proofs, Fate::equivalent, "why"));
}

ExitCode judged(const std::vector<MutantProof>& proofs) {
    if (proofs.empty()) throw CourseError("no mutant is of such a file: nothing was proved");
    const Sums sums = sums_of(proofs);
    fmt::print("{} mutants: {} do not compile, {} are equivalent, {} are killed, {} survive "
               "({:.1f} % killed)\n",
               sums.planted, sums.no_code, sums.equivalent, sums.killed, sums.survive,
               100 * sums.killed_share());
    return sums.survive == 0 ? ExitCode::success : ExitCode::judged_failed;
}

} // namespace raylab::app
