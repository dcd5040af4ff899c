// The system calls that no submission has reason to make, as a program of the kernel's filter.
#pragma once

#include <string>

namespace raylab::sandbox {

// The filter as bytes of struct sock_filter; empty where libseccomp does not know this processor.
// What it refuses fails with EPERM: the network, other processes' memory, mounts, namespaces, the
// kernel's modules, keys and tracing, io_uring (which would go around the filter).
std::string seccomp_filter();

} // namespace raylab::sandbox
