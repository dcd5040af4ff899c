#include "grader/sandbox/tier.h"

#include "grader/sandbox/bubblewrap.h"
#include "grader/sandbox/cgroup.h"
#include "grader/sandbox/landlock.h"
#include "grader/sandbox/sandbox.h"
#include "grader/sandbox/seccomp_filter.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

namespace raylab::sandbox {

namespace {

// Whether a child of this process can become a user of its own.
bool can_change_user() {
    if (geteuid() != 0) return false;
    const pid_t child = fork();
    if (child == 0) _exit(setresuid(sandbox_user(), sandbox_user(), sandbox_user()) == 0 ? 0 : 1);
    int status = 1;
    return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

// Mounts of a namespace of one's own vanish with the process, however it ends.
bool can_mount() {
    return geteuid() == 0 && unshare(CLONE_NEWNS) == 0 &&
           mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

void note(Isolation& found, bool there, const std::string& layer, const std::string& why_not) {
    if (there)
        found.layers.push_back(layer);
    else
        found.missing.push_back(layer + ": " + why_not);
}

// What all tiers have in common.
Isolation around_any_tier() {
    static const bool own_user = can_change_user(), mounts = can_mount();
    Isolation found;
    const Cgroup group(1 << 28, 64);
    found.own_user = own_user;
    found.mounts = mounts;
    found.memory = group.memory();
    found.pids = group.pids();
    note(found, found.own_user, "own user",
         "the grader is not root, so a program runs as the grader's user");
    note(found, found.memory, "memory of all processes", "no control group: " + group.trouble());
    note(found, found.pids, "number of processes", "no control group: " + group.trouble());
    note(found, found.mounts, "disk space and number of files",
         "the grader may not mount a tmpfs of limited size");
    return found;
}

std::string trial(const Isolation& isolation) {
    const Outcome outcome = run({"/usr/bin/true"}, {.limits = {.wall_seconds = 10}}, isolation);
    if (outcome.succeeded()) return "";
    return outcome.end == End::not_started ? outcome.trouble : why(outcome, {}) + outcome.output;
}

// Why not, or "".
std::string try_isolated(Isolation& found) {
    found.tier = Tier::isolated;
    found.maps = true;
    if (bubblewrap_program().empty())
        return "bubblewrap is not installed: apt-get install bubblewrap";
    if (seccomp_filter().empty()) return "libseccomp does not know this processor";
    return trial(found);
}

std::string try_confined(Isolation& found) {
    found.tier = Tier::confined;
    found.maps = false;
    if (!found.own_user)
        return "the grader is not root and cannot give a program a user of its own";
    if (landlock_version() == 0) return "the kernel has no Landlock";
    if (seccomp_filter().empty()) return "libseccomp does not know this processor";
    return trial(found);
}

Isolation find(Tier wanted_at_most) {
    Isolation found = around_any_tier();
    std::string why_not = "not asked for";
    if (wanted_at_most == Tier::isolated) why_not = try_isolated(found);
    note(found, why_not.empty(), "namespaces (bubblewrap) and seccomp", why_not);
    if (why_not.empty()) return found;
    why_not = "not asked for";
    if (wanted_at_most != Tier::limited) why_not = try_confined(found);
    note(found, why_not.empty(),
         fmt::format("Landlock (version {}) and seccomp", landlock_version()), why_not);
    if (why_not.empty()) return found;
    found.tier = Tier::limited;
    found.maps = false;
    return found;
}

} // namespace

std::string Isolation::sentence() const {
    std::string text = fmt::format("tier {}{}", static_cast<int>(tier),
                                   tier == Tier::limited ? " UNSANDBOXED" : "");
    if (!layers.empty()) text += fmt::format(" ({})", fmt::join(layers, ", "));
    if (!missing.empty()) text += fmt::format("; missing: {}", fmt::join(missing, "; "));
    return text;
}

const Isolation& best_isolation() {
    static const Isolation best = find(Tier::isolated);
    return best;
}

Isolation isolation_of(Tier tier) {
    const Isolation found = find(tier);
    if (found.tier != tier)
        throw std::runtime_error(fmt::format("this machine has no sandbox of tier {}: {}",
                                             static_cast<int>(tier), found.sentence()));
    return found;
}

// A number without a name. Distinct from that of every other grader that lives, so that whoever
// ends all processes of this user ends nobody else's.
std::uint32_t sandbox_user() { return 0x30000000u + static_cast<std::uint32_t>(getpid()); }

} // namespace raylab::sandbox
