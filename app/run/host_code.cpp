// Reads clang's "f.cu:5:7: error: text", and the note that follows, and two of its warnings; see
// host_code.h.
#include "app/run/host_code.h"

#include "common/cli/files.h"
#include "common/cli/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace raylab::app {

namespace fs = std::filesystem;
using simt::Finding;
using simt::SourcePlace;

namespace {

constexpr double clang_limit_seconds = 60;

struct ClangLine {
    SourcePlace place;
    bool is_error;
    std::string text;
};

std::vector<ClangLine> lines_of(const std::string& words) {
    static const std::regex said(R"(^(.+?):(\d+):(\d+): (fatal error|error|warning|note): (.*)$)");
    std::vector<ClangLine> lines;
    std::istringstream stream(words);
    for (std::string line; std::getline(stream, line);) {
        std::smatch part;
        if (!std::regex_match(line, part, said)) continue;
        lines.push_back(
            {{part[1], std::stoi(part[2]), std::stoi(part[3])}, part[4] != "note", part[5]});
    }
    return lines;
}

std::string quoted(const std::string& text) {
    const std::size_t begin = text.find('\''), end = text.find('\'', begin + 1);
    return end == text.npos ? "this" : text.substr(begin + 1, end - begin - 1);
}

std::string user(const std::string& attribute) { // in words
    return attribute == "__global__" ? "a kernel" : "a function of the GPU";
}

// One of the warnings that are asked for below.
Finding meaning_of_warning(const ClangLine& warning) {
    Finding finding;
    finding.severity = simt::Severity::warning;
    finding.place = warning.place;
    const std::size_t option = warning.text.rfind(" [-W");
    if (warning.text.find("-Wuninitialized]") != std::string::npos) {
        finding.kind = "uninitialised-local";
        finding.message = fmt::format("the local variable {} is used before it has a value",
                                      quoted(warning.text));
        finding.advice = "give it a value where it is declared";
    } else {
        finding.kind = "printf-format";
        finding.message = "printf: " + warning.text.substr(0, option);
        finding.advice = "let format and argument agree: %d for int, %u for unsigned, %zu for "
                         "size_t, %g for float and double";
    }
    return finding;
}

// The error, and the note that says why, if there is one; no kind: it is about something else.
Finding meaning(const ClangLine& error, const ClangLine* why) {
    static const std::regex uses(R"(reference to __host__ (function|variable) '.*' in (\S+).*)");
    static const std::regex call(R"(.*not viable: call to (\S+) function from (\S+) function)");
    Finding finding;
    finding.place = error.place;
    const std::string name = quoted(error.text);
    std::smatch part;
    if (error.text.find("call to global function") != std::string::npos) {
        finding.kind = "kernel-called";
        finding.message = fmt::format("the kernel {} is called as a function", name);
        finding.advice = fmt::format("launch it: {}<<<blocks, threads>>>(...)", name);
        return finding;
    }
    if (why == nullptr) return {};
    const std::string declared = fmt::format("{}:{}", why->place.file, why->place.line);
    if (std::regex_match(error.text, part, uses) && part[1] == "variable") {
        finding.kind = "host-variable";
        finding.message = fmt::format("{} uses the variable {} of the host", user(part[2]), name);
        finding.advice =
            fmt::format("pass its value as an argument, or write __device__ or __constant__ in "
                        "front of it ({}) and copy with cudaMemcpyToSymbol()",
                        declared);
    } else if (std::regex_match(error.text, part, uses) ||
               (std::regex_match(why->text, part, call) && part[1] == "__host__")) {
        finding.kind = "host-function";
        finding.message = fmt::format("{} calls {}, a function of the host", user(part[2]), name);
        finding.advice =
            fmt::format("write __device__ or __host__ __device__ in front of it ({})", declared);
    } else if (std::regex_match(why->text, part, call) && part[1] == "__device__") {
        finding.kind = "device-function";
        finding.message = fmt::format("host code calls {}, a function of the GPU", name);
        finding.advice = fmt::format(
            "call it in a kernel, or write __host__ __device__ in front of it ({})", declared);
    }
    return finding.kind.empty() ? Finding{} : finding;
}

// Of the notes behind an error the one that says that a function is of the wrong side.
const ClangLine* reason(const std::vector<ClangLine>& lines, std::size_t error) {
    for (std::size_t i = error + 1; i < lines.size() && !lines[i].is_error; ++i) {
        const std::string& text = lines[i].text;
        if (text.find("not viable: call to") != text.npos ||
            text.find("declared here") != text.npos)
            return &lines[i];
    }
    return nullptr;
}

} // namespace

std::vector<Finding> findings_of_clang(const std::string& words,
                                       const std::vector<std::string>& folders, bool& understood) {
    const auto is_foreign = [&](const std::string& file) {
        return std::any_of(folders.begin(), folders.end(),
                           [&](const std::string& folder) { return file.starts_with(folder); });
    };
    std::vector<Finding> findings;
    understood = true;
    const std::vector<ClangLine> lines = lines_of(words);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].is_error) continue;
        const bool warns =
            lines[i].text.ends_with("]") && lines[i].text.find(" [-W") != std::string::npos;
        const ClangLine* why = warns ? nullptr : reason(lines, i);
        const Finding finding = warns ? meaning_of_warning(lines[i]) : meaning(lines[i], why);
        if (warns && is_foreign(finding.place.file)) continue;
        if (finding.kind.empty() || is_foreign(finding.place.file) ||
            (why && is_foreign(why->place.file)))
            understood = false;
        else
            findings.push_back(finding);
    }
    return simt::folded(findings);
}

HostCode host_code_in_kernels(const Tree& tree, const RunOptions& options,
                              const std::vector<std::string>& sources) {
    std::vector<std::string> command = {"clang++",
                                        "-std=c++20",
                                        "-x",
                                        "cuda",
                                        "--cuda-device-only",
                                        "-nocudainc",
                                        "-nocudalib",
                                        "-Xclang",
                                        "-fcuda-allow-variadic-functions",
                                        "-fsyntax-only",
                                        "-Wno-everything",
                                        "-Wuninitialized",
                                        "-Wformat",
                                        "-ferror-limit=0",
                                        "-fno-caret-diagnostics",
                                        "-I",
                                        tree.root.string(),
                                        "-isystem",
                                        (tree.root / "common/simt/include").string(),
                                        "-include",
                                        (tree.root / "common/simt/editor_programs.h").string()};
    for (const std::string& folder : options.include_folders)
        command.insert(command.end(), {"-I", folder});
    for (const std::string& define : options.defines) command.push_back("-D" + define);
    const std::vector<std::string> folders = {"/usr/", (tree.root / "common/simt/").string()};
    HostCode all;
    for (const std::string& source : sources) {
        if (ending_of(source) != ".cu") continue;
        std::vector<std::string> words = command;
        words.push_back(source);
        const ProcessResult result = run_process(words, {.limit_seconds = clang_limit_seconds});
        if (!result.started) return {{}, "clang++ is not installed"};
        bool understood = true;
        for (Finding& finding : findings_of_clang(result.output, folders, understood)) {
            finding.mode = "compile";
            all.findings.push_back(std::move(finding));
        }
        if (!understood || result.timed_out || result.signal != 0)
            all.unchecked = fmt::format("clang cannot read {}", source);
    }
    return all;
}

} // namespace raylab::app
