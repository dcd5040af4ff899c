// The corpus of wrong and of right kernels (tests/machine/cuda), in every mode of the machine. A
// mistake that nobody is said to find yet ("none") is not asked for.
//
// RAYLAB_CORPUS=bounds,races chooses modes, RAYLAB_CORPUS_FILES=w31,w9 the programs whose names
// begin so; without either every eighth program in watch, and with RAYLAB_LONG all in all.
// RAYLAB_CORPUS_TABLE names a file for the table of results.
#include "app/run/build_program.h"
#include "app/run/merge.h"
#include "app/run/order.h"
#include "app/run/tests/expectation.h"
#include "app/run/work_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <thread>

namespace raylab::app {
namespace {

namespace fs = std::filesystem;

const Tree tree = {RAYLAB_ROOT};

bool is_chosen(const std::string& mode) {
    if (const char* modes = std::getenv("RAYLAB_CORPUS"))
        return std::string(modes).find(mode) != std::string::npos;
    return mode == "watch" || std::getenv("RAYLAB_LONG");
}

RunOptions options_for(const CorpusFile& file) {
    RunOptions options;
    options.inputs = {file.path.string()};
    options.time_limit = 2;
    return options;
}

// All programs, compiled by as many at a time as there are processors.
std::vector<BuiltProgram> build_all(const std::vector<CorpusFile>& corpus, const Machine& machine,
                                    const fs::path& folder) {
    std::vector<BuiltProgram> programs(corpus.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i; (i = next++) < corpus.size();)
            programs[i] = build_program(tree, machine, {corpus[i].path.string()},
                                        options_for(corpus[i]), folder / corpus[i].name());
    };
    std::vector<std::thread> helpers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
    return programs;
}

std::vector<simt::Finding> found(const CorpusFile& file, const BuiltProgram& program,
                                 const Mode& mode, bool orders) {
    if (program.file.empty()) return program.findings;
    const RunOptions options = options_for(file);
    std::vector<Execution> runs;
    if (!orders) {
        runs.push_back(execute(mode, program.file, "", options, Output::hidden));
        return merged(runs);
    }
    for (const char* order : {"forward", "forward", "reverse", "random:1"}) {
        runs.push_back(execute(mode, program.file, order, options, Output::hidden));
        if (runs.back().process.timed_out) break;
    }
    auto dependence = order_dependence(runs, file.path.string());
    runs.back().findings.insert(runs.back().findings.end(), dependence.begin(), dependence.end());
    return merged(runs);
}

// The whole corpus takes minutes to compile.
std::vector<CorpusFile> chosen_programs() {
    const std::vector<CorpusFile> all = read_corpus(tree.root / "tests/machine/cuda");
    const char* names = std::getenv("RAYLAB_CORPUS_FILES");
    if (!names && (std::getenv("RAYLAB_LONG") || std::getenv("RAYLAB_CORPUS"))) return all;
    const std::vector<std::string> starts = split(names ? names : "", ',');
    std::vector<CorpusFile> kept;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (names ? std::any_of(starts.begin(), starts.end(),
                                [&](const auto& start) { return all[i].name().starts_with(start); })
                  : i % 8 == 0)
            kept.push_back(all[i]);
    return kept;
}

void check(const std::string& name) {
    const Mode& mode = mode_named(name == "order" ? "plain" : name);
    const std::vector<CorpusFile> corpus = chosen_programs();
    const Machine machine = build_machine(tree, mode);
    const WorkFolder work("");
    const auto programs = build_all(corpus, machine, work.path() / name);
    int expected = 0, made = 0, alarms = 0;
    std::string table;
    for (std::size_t i = 0; i < corpus.size(); ++i) {
        const CorpusFile& file = corpus[i];
        const bool must_compile = !file.expects("compile");
        EXPECT_EQ(programs[i].file.empty(), !must_compile) << file.name() << programs[i].words;
        const auto findings = found(file, programs[i], mode, name == "order");
        const std::string asked = must_compile ? name : "compile";
        const auto missing = file.missing(asked, findings), surplus = file.surplus(findings);
        for (const auto& text : missing) ADD_FAILURE() << file.name() << ": not found: " << text;
        for (const auto& text : surplus) ADD_FAILURE() << file.name() << ": surplus: " << text;
        expected += file.expects(asked);
        made += file.expects(asked) && missing.empty();
        alarms += !surplus.empty();
        table += fmt::format("{} {} {}\n", name, file.name(),
                             !surplus.empty()        ? "false"
                             : !missing.empty()      ? "missed"
                             : file.expects(asked)   ? "found"
                             : file.expected.empty() ? "silent"
                                                     : "-");
    }
    fmt::print("{}: found {} of {}, {} false alarms, in {} programs\n", name, made, expected,
               alarms, corpus.size());
    if (const char* path = std::getenv("RAYLAB_CORPUS_TABLE"))
        std::ofstream(path, std::ios::app) << table;
}

std::vector<std::string> chosen_modes() {
    std::vector<std::string> modes;
    for (const char* mode : {"plain", "bounds", "races", "watch", "order"})
        if (is_chosen(mode)) modes.push_back(mode);
    return modes;
}

class Corpus : public testing::TestWithParam<std::string> {};

TEST_P(Corpus, IsFoundAtItsLines) { check(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Modes, Corpus, testing::ValuesIn(chosen_modes()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace raylab::app
