// What happens in the new process between fork() and exec(): nothing is allocated, since another
// thread may have held the heap's lock at the fork.
#pragma once

#include <cstdint>
#include <vector>

#include <linux/filter.h>

namespace raylab::sandbox {

struct HandleMove {
    int from, to;
};

struct ChildPlan {
    std::vector<char*> arguments, environment; // with a null behind the last
    const char* folder = nullptr;              // to change to; null: bubblewrap does it
    int go = -1;                               // a byte comes when the control group is ready
    int status = -1;                           // what failed is written here; closes at exec()
    int input = -1, output = -1;               // standard input; standard output and error
    std::vector<HandleMove> handles;           // `from` 100 or more, `to` 3 to 11
    std::uint32_t user = 0;                    // 0: keeps the grader's
    std::uint64_t cpu_seconds = 0, file_size = 0, data = 0, processes = 0; // 0: no limit
    int landlock = -1;                                                     // rules to apply
    sock_fprog filter = {0, nullptr}; // to apply, unless bubblewrap does
};

// What the child says on `status` if it cannot begin.
struct ChildTrouble {
    char step[32];
    int error;
};

[[noreturn]] void become(const ChildPlan& plan);

} // namespace raylab::sandbox
