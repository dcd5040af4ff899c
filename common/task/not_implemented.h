// What a stub says. Once per place, however many threads come by:
//     task 2.3 add_iteration() is not implemented: labs/02_iterative/renderer.cu:41
#pragma once

#include "common/math/hd.h"

#include <cstdio>

#if !defined(__CUDA_ARCH__)
#include <mutex>
#include <set>
#include <utility>
#endif

namespace raylab {

HD void not_implemented(const char* task, const char* function, const char* file = __builtin_FILE(),
                        int line = __builtin_LINE()) {
#if defined(__CUDA_ARCH__)
    if (blockIdx.x == 0 && threadIdx.x == 0)
        printf("task %s %s is not implemented: %s:%d\n", task, function, file, line);
#else
    static std::mutex mutex;
    static std::set<std::pair<const char*, int>> said;
    const std::lock_guard lock(mutex);
    if (said.emplace(file, line).second)
        std::fprintf(stderr, "task %s %s is not implemented: %s:%d\n", task, function, file, line);
#endif
}

} // namespace raylab
