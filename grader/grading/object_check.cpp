#include "grader/grading/object_check.h"

#include "grader/grading/allowed_symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace raylab::grading {

namespace {

sandbox::Outcome look(const std::string& script, const std::filesystem::path& build_folder,
                      const std::vector<std::string>& objects,
                      const sandbox::Isolation& isolation) {
    sandbox::SandboxOptions options;
    options.readable = {build_folder};
    options.folder = build_folder;
    options.limits = {.wall_seconds = 60, .memory = 1ull << 30, .output = 64ull << 20};
    options.whole_output = true;
    // The objects' names are the build's own. They are arguments, so no shell reads them.
    std::vector<std::string> command = {"/bin/sh", "-c", script, "sh"};
    command.insert(command.end(), objects.begin(), objects.end());
    return sandbox::run(command, options, isolation);
}

// A name that is missing was replaced in the tests' source: by a macro, or by a function that is
// found first.
std::string missing_words(const std::string& object, const Symbols& own, const Symbols& allowed) {
    for (const std::string& name : allowed.required)
        if (!own.used.contains(name) && !own.weak.contains(name))
            return fmt::format("{}: the tests no longer call {}", object, name);
    return "";
}

bool is_word_of_tests(const std::string& name) {
    return is_of(name, "7testing") || is_of(name, "6raylab4task");
}

void merge(Symbols& into, const Symbols& more) {
    into.used.insert(more.used.begin(), more.used.end());
    into.strong.insert(more.strong.begin(), more.strong.end());
    into.weak.insert(more.weak.begin(), more.weak.end());
}

} // namespace

ObjectSymbols read_symbols(const std::filesystem::path& build_folder,
                           const std::vector<std::string>& objects,
                           const sandbox::Isolation& isolation) {
    ObjectSymbols all;
    if (objects.empty()) return all;
    // Each line: "object: name type ...", where the type is U (used), upper case (strong), W, V, u
    // (weak), or lower case (of this object alone).
    const sandbox::Outcome outcome =
        look("exec /usr/bin/nm -A -P \"$@\"", build_folder, objects, isolation);
    if (!outcome.succeeded())
        throw std::runtime_error("nm could not read the objects: " + outcome.output.substr(0, 500) +
                                 outcome.trouble);
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(": ");
        std::istringstream words(colon == line.npos ? "" : line.substr(colon + 2));
        std::string name, type;
        if (!(words >> name >> type) || type.size() != 1) continue;
        Symbols& symbols = all[line.substr(0, colon)];
        if (type == "U")
            symbols.used.insert(name);
        else if (type == "W" || type == "V" || type == "u" || type == "w" || type == "v")
            symbols.weak.insert(name);
        else if (std::isupper(static_cast<unsigned char>(type[0])) || type == "i")
            symbols.strong.insert(name);
    }
    return all;
}

bool calls_the_kernel(const std::filesystem::path& build_folder,
                      const std::vector<std::string>& objects,
                      const sandbox::Isolation& isolation) {
    if (objects.empty()) return false;
    const sandbox::Outcome outcome =
        look("for object; do objdump -d --no-show-raw-insn \"$object\" || exit 2; done | "
             "grep -E -m 1 '\\s(syscall|sysenter|int +.0x80|svc)\\b'",
             build_folder, objects, isolation);
    if (outcome.end != sandbox::End::exited || outcome.exit_code > 1)
        throw std::runtime_error("objdump could not read the objects: " + outcome.trouble);
    return outcome.exit_code == 0;
}

std::string first_suspicion(const ObjectSymbols& submission, const ObjectSymbols& allowed,
                            const std::string& lab_number) {
    Symbols anywhere;
    for (const auto& [object, symbols] : allowed) merge(anywhere, symbols);
    for (const auto& [object, own] : submission) {
        const auto found = allowed.find(object);
        const Symbols here = found == allowed.end() ? Symbols{} : found->second;
        for (const std::string& name : own.strong)
            if (!here.strong.contains(name) && !here.weak.contains(name) &&
                !may_define(name, lab_number))
                return fmt::format("{}: defines {}", object, name);
        for (const std::string& name : own.weak)
            if (!here.weak.contains(name) && !here.strong.contains(name) &&
                !may_define_weakly(name, lab_number))
                return fmt::format("{}: defines {}", object, name);
        for (const std::string& name : own.used)
            if (!anywhere.used.contains(name) && !anywhere.strong.contains(name) &&
                !anywhere.weak.contains(name) && !may_use(name))
                return fmt::format("{}: uses {}", object, name);
        if (const std::string missing = missing_words(object, own, here); !missing.empty())
            return missing;
    }
    return "";
}

std::string to_text(const ObjectSymbols& symbols) {
    std::string text;
    for (const auto& [object, names] : symbols)
        for (const auto& [kind, set] : {std::pair{'U', &names.used},
                                        {'T', &names.strong},
                                        {'W', &names.weak},
                                        {'R', &names.required}})
            for (const std::string& name : *set)
                text += fmt::format("{} {} {}\n", kind, name, object);
    return text;
}

ObjectSymbols symbols_of_text(const std::string& text) {
    ObjectSymbols all;
    std::istringstream lines(text);
    char kind;
    for (std::string name, object;
         lines >> kind >> name && std::getline(lines >> std::ws, object);) {
        Symbols& symbols = all[object];
        (kind == 'U'   ? symbols.used
         : kind == 'T' ? symbols.strong
         : kind == 'W' ? symbols.weak
                       : symbols.required)
            .insert(name);
    }
    return all;
}

ObjectSymbols allowed_by(const ObjectSymbols& students_tree, const ObjectSymbols& solution) {
    ObjectSymbols allowed = solution;
    for (const auto& [object, stubs] : students_tree) {
        Symbols& both = allowed[object];
        for (const std::set<std::string>* names : {&both.used, &both.weak})
            for (const std::string& name : *names)
                if (is_word_of_tests(name) &&
                    (stubs.used.contains(name) || stubs.weak.contains(name)))
                    both.required.insert(name);
        merge(both, stubs);
    }
    return allowed;
}

} // namespace raylab::grading
