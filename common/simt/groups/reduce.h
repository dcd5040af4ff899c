// cooperative_groups: sums, minima and running sums over the lanes of a group.
#pragma once

#include "common/simt/groups/lanes.h"

namespace cooperative_groups {

template <class T = void> struct plus {
    T operator()(T a, T b) const { return a + b; }
};
template <class T = void> struct less { // the smaller one
    T operator()(T a, T b) const { return b < a ? b : a; }
};
template <class T = void> struct greater {
    T operator()(T a, T b) const { return a < b ? b : a; }
};
template <class T = void> struct bit_and {
    T operator()(T a, T b) const { return a & b; }
};
template <class T = void> struct bit_or {
    T operator()(T a, T b) const { return a | b; }
};
template <class T = void> struct bit_xor {
    T operator()(T a, T b) const { return a ^ b; }
};

// All members combined, in the order of their ranks. Every member gets the result.
template <class T, class Combine>
inline T reduce(const Lanes& group, T value, Combine combine, Where where = Where::here()) {
    T result = value;
    bool first = true;
    group.for_each("reduce()", where, value, [&](T other) {
        result = first ? other : T(combine(result, other));
        first = false;
    });
    return result;
}

// The members up to and with the caller.
template <class T, class Combine>
inline T inclusive_scan(const Lanes& group, T value, Combine combine, Where where = Where::here()) {
    T result = value;
    unsigned rank = group.thread_rank(), at = 0;
    group.for_each("inclusive_scan()", where, value, [&](T other) {
        if (at <= rank) result = at == 0 ? other : T(combine(result, other));
        ++at;
    });
    return result;
}
template <class T> inline T inclusive_scan(const Lanes& group, T value) {
    return inclusive_scan(group, value, plus<T>());
}

// The members before the caller; the first one gets T().
template <class T, class Combine>
inline T exclusive_scan(const Lanes& group, T value, Combine combine, Where where = Where::here()) {
    T result{};
    unsigned rank = group.thread_rank(), at = 0;
    group.for_each("exclusive_scan()", where, value, [&](T other) {
        if (at < rank) result = at == 0 ? other : T(combine(result, other));
        ++at;
    });
    return result;
}
template <class T> inline T exclusive_scan(const Lanes& group, T value) {
    return exclusive_scan(group, value, plus<T>());
}

} // namespace cooperative_groups
