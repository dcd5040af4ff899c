#include "app/gdb.h"

#include "common/cli/process.h"

#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>

namespace raylab::app {

void run_gdb(const std::filesystem::path& root, const std::string& stop,
             const std::vector<std::string>& command) {
    std::string line = "gdb -q -iex 'set debuginfod enabled off' -x " +
                       in_quotes((root / "app/gdb_kernels.py").string()) + " -d " +
                       in_quotes(root.string()) + " -ex " + in_quotes("break " + stop) +
                       " -ex run --args";
    for (const std::string& word : command) line += " " + in_quotes(word);
    // system() leaves Ctrl-C to gdb; a shell that does not find the program ends with 127.
    const int status = std::system(line.c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        throw std::runtime_error("there is no gdb: on Debian, apt-get install gdb");
}

} // namespace raylab::app
