#include "common/cli/leftovers.h"

#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace raylab {

namespace {

// More than are ever in use at once. A file or a child that finds no free slot is not cleaned up.
constexpr int slots = 16;
std::atomic<const char*> files[slots];
std::atomic<pid_t> children[slots];
std::atomic<int> being_started{0}, status_of_end{0};
static_assert(std::atomic<const char*>::is_always_lock_free &&
                  std::atomic<pid_t>::is_always_lock_free,
              "a signal handler may touch nothing that another thread has locked");

template <class T> std::atomic<T>* take_slot(std::atomic<T> (&all)[slots], T value) {
    for (std::atomic<T>& slot : all) {
        T none{};
        if (slot.compare_exchange_strong(none, value)) return &slot;
    }
    return nullptr;
}

} // namespace

UnfinishedFile::UnfinishedFile(const char* path) {
    std::snprintf(path_.data(), path_.size(), "%s", path);
    slot_ = take_slot<const char*>(files, path_.data());
}

UnfinishedFile::~UnfinishedFile() {
    if (slot_) *slot_ = nullptr;
}

RunningChild::RunningChild() { ++being_started; }

void RunningChild::started(pid_t child) {
    if (child > 0) slot_ = take_slot(children, child);
    if (--being_started == 0 && status_of_end != 0) end_without_leftovers(status_of_end);
}

RunningChild::~RunningChild() {
    if (slot_) *slot_ = 0;
}

void end_without_leftovers(int status) {
    status_of_end = status;
    if (being_started > 0) return;
    for (const auto& child : children)
        if (const pid_t group = child) kill(-group, SIGKILL);
    for (const auto& file : files)
        if (const char* path = file) unlink(path);
    _exit(status);
}

} // namespace raylab
