// A read-only array in the memory of the machine that runs the kernel: the host or a device.
#pragma once

#include "common/math/hd.h"

namespace raylab {

template <class T> struct Array {
    const T* data = nullptr;
    int size = 0;

    HD const T& operator[](int i) const { return data[i]; }
};

} // namespace raylab
