// How well this machine can shut a program in: three tiers, found by trial.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace raylab::sandbox {

enum class Tier {
    isolated = 1, // bubblewrap: namespaces of its own, a seccomp filter, no capability
    confined = 2, // no namespaces: a user of its own, Landlock, a seccomp filter
    limited = 3,  // limits of the process alone: it reads what the grader reads
};

struct Isolation {
    Tier tier = Tier::limited;
    bool maps = false;                 // files may be seen elsewhere than they are
    bool own_user = false;             // a user id that nobody else has
    bool memory = false, pids = false; // a control group limits all its processes together
    bool mounts = false;               // this process can mount a tmpfs of limited size
    std::vector<std::string> layers;   // what holds, for people
    std::vector<std::string> missing;  // what does not, and why

    // "tier 1 (bubblewrap, own user, ...)", with what is missing, and UNSANDBOXED for tier 3.
    std::string sentence() const;
};

// The best that works here; tried once, at the first call.
const Isolation& best_isolation();

// That of a tier, for tests and for comparison. Throws std::runtime_error if it does not work here.
Isolation isolation_of(Tier tier);

// The user and group that programs run as; unique to this process. Only if Isolation::own_user.
std::uint32_t sandbox_user();

} // namespace raylab::sandbox
