#include "common/simt/watch/knowledge.h"

namespace raylab::simt::watch {

void Knowledge::learn(const Knowledge& other) {
    if (other.all_) all_ = true;
    for (const auto& [block, epochs] : other.blocks_) raise(blocks_, block, epochs);
    for (const auto& [task, time] : other.tasks_) raise(tasks_, task, time);
}

bool Knowledge::knows(Task task, uint32_t block, Time time) const {
    if (all_) return true;
    if (const auto found = blocks_.find(block);
        found != blocks_.end() && epoch_of(time) < found->second)
        return true;
    const auto found = tasks_.find(task);
    return found != tasks_.end() && time <= found->second;
}

} // namespace raylab::simt::watch
