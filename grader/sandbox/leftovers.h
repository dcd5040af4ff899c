// Ends what a program leaves behind: processes that it started, and zombies.
#pragma once

#include <cstdint>
#include <sys/types.h>

namespace raylab::sandbox {

// A process of the sandbox's user kills all processes of that user: it may kill no others.
void kill_user(std::uint32_t user);

// Whose parent has ended becomes a child of this process (PR_SET_CHILD_SUBREAPER): a zombie would
// count among the processes of its user. bubblewrap leaves the first process of its namespace
// behind like that. `session`: of the program.
void reap_orphans(pid_t session);

} // namespace raylab::sandbox
