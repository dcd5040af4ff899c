// The CPU machine keeps __shared__ variables as thread-local ones of their function, so the object
// file's table of symbols has their sizes.
#include "app/run/shared_limit.h"

#include "common/cli/files.h"
#include "common/cli/process.h"

#include <fmt/format.h>

#include <map>
#include <regex>
#include <sstream>

namespace raylab::app {

namespace {

constexpr unsigned long most_static_shared =
    48 << 10; // CUDA C++ Programming Guide, Technical Specifications

// The first line of the source that declares a __shared__ variable of this name; 1 if there is
// none.
int line_of(const std::string& source, const std::string& variable) {
    std::istringstream lines(read_file(source));
    const std::regex declaration("__shared__.*\\b" + variable + "\\b");
    int number = 0;
    for (std::string line; std::getline(lines, line);)
        if (++number; std::regex_search(line, declaration)) return number;
    return 1;
}

} // namespace

std::string too_much_shared(const std::filesystem::path& object, const std::string& source) {
    const ProcessResult table =
        run_process({"readelf", "-sW", "--demangle", object.string()}, {60});
    if (!table.succeeded()) return {};
    // "  12: 0000000000000000 65536 TLS LOCAL DEFAULT 8 k(float const*, float*)::s"
    static const std::regex row(R"(\s*\d+: [0-9a-f]+\s+(\d+) TLS\s+\S+\s+\S+\s+\d+ (.*)::(\w+).*)");
    struct Function {
        unsigned long bytes = 0, largest = 0;
        std::string variable; // the largest
    };
    std::map<std::string, Function> functions;
    std::istringstream lines(table.output);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (!std::regex_match(line, match, row)) continue;
        Function& function = functions[match[2]];
        const unsigned long bytes = std::stoul(match[1]);
        function.bytes += bytes;
        if (bytes > function.largest) function.largest = bytes, function.variable = match[3];
    }
    std::string errors;
    for (const auto& [name, function] : functions)
        if (function.bytes > most_static_shared)
            errors +=
                fmt::format("{}:{}: error: too much shared memory: {} has {} bytes of __shared__ "
                            "variables, and a block at most {}; more is for dynamic shared memory "
                            "alone (cudaFuncAttributeMaxDynamicSharedMemorySize)\n",
                            source, line_of(source, function.variable), name, function.bytes,
                            most_static_shared);
    return errors;
}

} // namespace raylab::app
