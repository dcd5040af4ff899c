// Compiles a program as raylab's own kernels are compiled; see build_program.h.
//
// The compiler runs in the folder of the program, with names relative to it: so ccache knows a
// source again whose folder had another name.
#include "app/run/build_program.h"

#include "app/run/compiler_errors.h"
#include "app/run/process_words.h"
#include "app/run/shared_limit.h"
#include "common/cli/files.h"
#include "common/cli/process.h"
#include "common/cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

constexpr double compile_limit_seconds = 600;

bool is_source(const fs::path& file) {
    const std::string ending = ending_of(file);
    return ending == ".cu" || ending == ".cpp" || ending == ".cc" || ending == ".cxx" ||
           ending == ".c";
}

std::string before(const std::string& command, const std::string& word) {
    return command.substr(0, command.find(word));
}

class Builder {
  public:
    Builder(const Tree& tree, const Machine& machine, const RunOptions& options,
            const fs::path& folder)
        : machine_(machine), folder_(folder), includes_(options.include_folders) {
        flags_ = before(machine.compile, " -MD ") + machine.mode->flags;
        flags_ += " -isystem " + in_quotes((tree.root / "common/simt/include").string());
        for (const std::string& include : options.include_folders)
            flags_ += (fs::exists(fs::path(include) / "thrust/version.h") ? " -isystem " : " -I") +
                      in_quotes(fs::absolute(include).string());
        for (const std::string& define : options.defines) flags_ += " -D" + in_quotes(define);
    }

    // Whether it went well; the tools' words are kept.
    bool compile(const std::string& source, std::size_t number) {
        const std::string stem = fmt::format("{}_{}", number, fs::path(source).stem().string());
        const std::string object = stem + ".o";
        const fs::path place = fs::absolute(source);
        std::string to_compile = place.string(), flags = flags_;
        if (ending_of(source) == ".cu") {
            const fs::path tree = folder_ / std::to_string(number);
            if (!run(rewriting(source, tree), {})) return false;
            to_compile = fs::path(words_of_last_).lexically_relative(folder_).string();
        }
        if (ending_of(source) == ".c") flags += " -std=gnu17 -x c"; // as nvcc: not C++
        flags += " -iquote " + in_quotes(place.parent_path().string());
        objects_ += " " + in_quotes((folder_ / object).string());
        if (!run({"/bin/sh", "-c",
                  flags + " -o " + in_quotes(object) + " -c " + in_quotes(to_compile)},
                 folder_))
            return false;
        const std::string errors = too_much_shared(folder_ / object, source);
        words += errors;
        return errors.empty();
    }

    bool link(const fs::path& program) {
        std::string command = machine_.link;
        const auto replace = [&](const std::string& word, const std::string& with) {
            const std::size_t at = command.find(word);
            if (at == command.npos) throw std::runtime_error("cannot read: " + machine_.link);
            command.replace(at, word.size(), with);
        };
        const std::size_t end =
            command.find("empty_cu.cpp.o") + std::string("empty_cu.cpp.o").size();
        const std::size_t begin = command.rfind(' ', end - 1) + 1;
        command.replace(begin, end - begin, objects_);
        replace(" -o common/simt/simt_program", " -o " + in_quotes(program.string()));
        return run({"/bin/sh", "-c", command}, machine_.folder);
    }

    std::string words;

  private:
    // Where the user is, so that #line names files as the user does. Prints the copy's path.
    std::vector<std::string> rewriting(const std::string& source, const fs::path& tree) const {
        std::vector<std::string> command = {machine_.rewriter.string(), "--tree", source,
                                            tree.string()};
        command.insert(command.end(), includes_.begin(), includes_.end());
        return command;
    }

    bool run(const std::vector<std::string>& command, const fs::path& where) {
        const ProcessResult result = run_process(command, {compile_limit_seconds, where});
        words_of_last_ = result.output.substr(0, result.output.find('\n'));
        if (command.front() != machine_.rewriter || !result.succeeded()) words += result.output;
        if (!result.started || result.timed_out || result.signal != 0)
            throw std::runtime_error(fmt::format("{}: {}", fs::path(command[0]).filename().string(),
                                                 why_failed(result)));
        return result.succeeded();
    }

    const Machine& machine_;
    fs::path folder_;
    std::vector<std::string> includes_;
    std::string flags_, objects_, words_of_last_;
};

} // namespace

std::vector<std::string> sources_of(const std::vector<std::string>& inputs) {
    std::vector<std::string> sources;
    for (const std::string& input : inputs) {
        if (!fs::exists(input))
            throw UsageError(fmt::format("there is no file or folder '{}': check the name", input));
        if (!fs::is_directory(input)) {
            if (!is_source(input))
                throw UsageError(fmt::format("'{}' is not a source of CUDA or C++: expected a name "
                                             "that ends in .cu, .cpp or .c",
                                             input));
            sources.push_back(input);
            continue;
        }
        const std::size_t before = sources.size();
        for (const auto& entry : fs::directory_iterator(input))
            if (entry.is_regular_file() && is_source(entry.path()))
                sources.push_back(entry.path().lexically_normal().string());
        if (sources.size() == before)
            throw UsageError(fmt::format("the folder '{}' has no file that ends in .cu or .cpp: "
                                         "give the one with the sources",
                                         input));
        std::sort(sources.begin() + std::ptrdiff_t(before), sources.end());
    }
    return sources;
}

BuiltProgram build_program(const Tree& tree, const Machine& machine,
                           const std::vector<std::string>& sources, const RunOptions& options,
                           const fs::path& folder) {
    fs::create_directories(folder);
    setenv("CCACHE_NOHASHDIR", "1", 1);
    Builder builder(tree, machine, options, folder);
    Progress progress(fmt::format("compiling ({})", machine.mode->name), int(sources.size()) + 1,
                      "files", 1);
    BuiltProgram built;
    const fs::path program = folder / "program";
    bool all_compile = true;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        all_compile = builder.compile(sources[i], i) && all_compile;
        progress.update(int(i) + 1);
    }
    if (all_compile && builder.link(program)) built.file = program;
    built.words = builder.words;
    if (built.file.empty())
        built.findings = compiler_errors(builder.words, sources, folder.string());
    return built;
}

} // namespace raylab::app
