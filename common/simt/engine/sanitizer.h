// What AddressSanitizer and ThreadSanitizer must be told about the engine. In an ordinary build all
// of these do nothing.
//
// The engine's files are not instrumented: its own accesses are made in the name of whichever CUDA
// thread runs, and would look like that thread's. What holds between CUDA threads is told in words
// instead: each is a fiber of its own, and a barrier is "all release, then all acquire".
#pragma once

#include <cstddef>

#if defined(RAYLAB_CHECK_ADDRESS)
#include <pthread.h>
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif
#if defined(RAYLAB_CHECK_THREAD)
#include <sanitizer/tsan_interface.h>
#endif

namespace raylab::simt {

#if defined(RAYLAB_CHECK_THREAD)
// Memory that two CUDA threads use one after the other would look shared, so each has its own
// stack.
inline constexpr bool one_stack_per_thread = true;
inline void announce_release(void* object) { __tsan_release(object); }
inline void announce_acquire(void* object) { __tsan_acquire(object); }
inline void announce_name(void* fiber, const char* name) { __tsan_set_fiber_name(fiber, name); }

// While one of these lives, what its thread does is nobody's business.
extern "C" void __tsan_ignore_thread_begin();
extern "C" void __tsan_ignore_thread_end();
struct Unobserved {
    Unobserved() { __tsan_ignore_thread_begin(); }
    ~Unobserved() { __tsan_ignore_thread_end(); }
};
#else
inline constexpr bool one_stack_per_thread = false;
inline void announce_release(void*) {}
inline void announce_acquire(void*) {}
inline void announce_name(void*, const char*) {}
#endif

#if defined(RAYLAB_CHECK_ADDRESS)
inline void forbid(const void* memory, size_t bytes) { __asan_poison_memory_region(memory, bytes); }
inline void allow(const void* memory, size_t bytes) {
    __asan_unpoison_memory_region(memory, bytes);
}
#else
inline void forbid(const void*, size_t) {}
inline void allow(const void*, size_t) {}
#endif

// Whether this is a build for finding bugs, in which fresh memory is filled with nonsense.
#if defined(RAYLAB_CHECK_ADDRESS) || defined(RAYLAB_CHECK_THREAD) || defined(RAYLAB_CHECK_WATCH)
inline constexpr bool check_build = true;
#else
inline constexpr bool check_build = false;
#endif

} // namespace raylab::simt
