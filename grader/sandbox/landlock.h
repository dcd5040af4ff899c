// Landlock: a process gives up all files but those that are named, for itself and its children.
// Needs neither root nor namespaces; Linux 5.13 and later.
#pragma once

#include <filesystem>
#include <vector>

namespace raylab::sandbox {

int landlock_version(); // 0: the kernel has none

// A set of rules as a descriptor, to be applied by restrict_self(); -1 if it cannot be made. Files
// that are not there are left out. From version 4 on no TCP, from version 6 on no signal and no
// abstract socket leads out. UDP has no rule: the seccomp filter refuses its sockets.
int landlock_rules(const std::vector<std::filesystem::path>& readable,
                   const std::vector<std::filesystem::path>& writable);

// In the child, after PR_SET_NO_NEW_PRIVS. False if the kernel refuses.
bool landlock_restrict_self(int rules);

} // namespace raylab::sandbox
