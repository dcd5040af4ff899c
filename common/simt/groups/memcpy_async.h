// cooperative_groups: copies by a whole group, which are done when the call returns; but, as on a
// GPU, the other members may count on them only after wait().
#pragma once

#include "common/simt/groups/thread_group.h"

#include <cstddef>

namespace cooperative_groups {

// Each member copies every size()-th byte, or unit.
template <class Group, class T>
inline void memcpy_async(const Group& group, T* to, const T* from, std::size_t bytes) {
    for (std::size_t i = std::size_t(group.thread_rank()); i < bytes / sizeof(T);
         i += std::size_t(group.size()))
        to[i] = from[i];
}
template <class Group>
inline void memcpy_async(const Group& group, void* to, const void* from, std::size_t bytes) {
    memcpy_async(group, static_cast<char*>(to), static_cast<const char*>(from), bytes);
}
// The shorter of two arrays is the limit.
template <class Group, class T>
inline void memcpy_async(const Group& group, T* to, std::size_t room, const T* from,
                         std::size_t count) {
    memcpy_async(group, to, from, (count < room ? count : room) * sizeof(T));
}

template <class Group> inline void wait(const Group& group, Where where = Where::here()) {
    group.sync(where);
}
template <unsigned Stages, class Group>
inline void wait_prior(const Group& group, Where where = Where::here()) {
    group.sync(where);
}

} // namespace cooperative_groups
