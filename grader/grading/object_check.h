// What a submission's object files may define and refer to.
//
// A task's functions compute: they have no reason to name main(), _exit(), fork(), open(),
// GoogleTest's classes, or to put their own operator new in the place of the library's. The rule is
// a list of what is allowed: what the same object file has in the students' tree or in the
// solution, and beside that the lab's own names, the C++ library's (without files and threads),
// mathematics, strings, printf() and the CUDA runtime.
#pragma once

#include "grader/sandbox/sandbox.h"

#include <map>
#include <set>
#include <string>

namespace raylab::grading {

// Names of an object file, mangled.
struct Symbols {
    std::set<std::string> used, strong, weak;
    std::set<std::string>
        required; // of `allowed`: the tests' own words, which no submission may lack
};
using ObjectSymbols = std::map<std::string, Symbols>; // by the object's name in the build folder

// Runs `nm` in the sandbox, since a submission could make the compiler write an object that `nm`
// stumbles over. Throws std::runtime_error.
ObjectSymbols read_symbols(const std::filesystem::path& build_folder,
                           const std::vector<std::string>& objects,
                           const sandbox::Isolation& isolation);

// Whether any of these objects has an instruction that calls the kernel.
bool calls_the_kernel(const std::filesystem::path& build_folder,
                      const std::vector<std::string>& objects, const sandbox::Isolation& isolation);

// "object: defines main()": the first thing that is not allowed; empty: nothing is.
std::string first_suspicion(const ObjectSymbols& submission, const ObjectSymbols& allowed,
                            const std::string& lab_number);

// As text, to be kept beside the base.
std::string to_text(const ObjectSymbols& symbols);
ObjectSymbols symbols_of_text(const std::string& text);

// What either has is allowed; the words of the tests that both have are required.
ObjectSymbols allowed_by(const ObjectSymbols& students_tree, const ObjectSymbols& solution);

} // namespace raylab::grading
