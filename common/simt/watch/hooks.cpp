// The functions that compilers call before accesses under -fsanitize=thread, and at a failed check
// under -fsanitize=bounds,integer-divide-by-zero,alignment. g++ and clang share their names.
#include "common/simt/watch/watcher.h"

#include "common/simt/watch/undefined.h"

#include <cstring>

#define HOOK extern "C" __attribute__((visibility("default"), noinline))
#define PC __builtin_return_address(0)
#define FRAME uintptr_t(__builtin_frame_address(0))

using raylab::simt::watch::quiet_reads;
using raylab::simt::watch::Touch;

constinit thread_local raylab::simt::watch::QuietReads raylab::simt::watch::quiet_reads{};

static void look(const void* p, unsigned bytes, bool writes, Touch touch, const void* pc) {
    raylab::simt::watch::Watcher::get().access(uintptr_t(p), bytes, writes, touch, pc);
}

__attribute__((always_inline)) static inline void read(const void* p, unsigned bytes,
                                                       uintptr_t frame, const void* pc) {
    if (!quiet_reads.passes(uintptr_t(p), bytes, frame, pc))
        look(p, bytes, false, Touch::plain, pc);
}

#define RAYLAB_HOOKS(bytes)                                                                        \
    HOOK void __tsan_read##bytes(void* p) { read(p, bytes, FRAME, PC); }                           \
    HOOK void __tsan_write##bytes(void* p) { look(p, bytes, true, Touch::plain, PC); }             \
    HOOK void __tsan_unaligned_read##bytes(void* p) { read(p, bytes, FRAME, PC); }                 \
    HOOK void __tsan_unaligned_write##bytes(void* p) { look(p, bytes, true, Touch::plain, PC); }   \
    HOOK void __tsan_volatile_read##bytes(void* p) {                                               \
        look(p, bytes, false, Touch::volatile_, PC);                                               \
    }                                                                                              \
    HOOK void __tsan_volatile_write##bytes(void* p) {                                              \
        look(p, bytes, true, Touch::volatile_, PC);                                                \
    }                                                                                              \
    HOOK void __tsan_unaligned_volatile_read##bytes(void* p) {                                     \
        look(p, bytes, false, Touch::volatile_, PC);                                               \
    }                                                                                              \
    HOOK void __tsan_unaligned_volatile_write##bytes(void* p) {                                    \
        look(p, bytes, true, Touch::volatile_, PC);                                                \
    }                                                                                              \
    HOOK void __tsan_read_write##bytes(void* p) {                                                  \
        look(p, bytes, false, Touch::plain, PC);                                                   \
        look(p, bytes, true, Touch::plain, PC);                                                    \
    }
RAYLAB_HOOKS(1)
RAYLAB_HOOKS(2)
RAYLAB_HOOKS(4)
RAYLAB_HOOKS(8)
RAYLAB_HOOKS(16)
#undef RAYLAB_HOOKS

HOOK void __tsan_read_range(void* p, unsigned long n) { read(p, unsigned(n), FRAME, PC); }
HOOK void __tsan_write_range(void* p, unsigned long n) {
    look(p, unsigned(n), true, Touch::plain, PC);
}
// clang from version 15 on has these in place of calls of memcpy() and its like, for structs, too.
HOOK void* __tsan_memcpy(void* to, const void* from, unsigned long n) {
    look(from, unsigned(n), false, Touch::plain, PC);
    look(to, unsigned(n), true, Touch::plain, PC);
    return std::memcpy(to, from, n);
}
HOOK void* __tsan_memmove(void* to, const void* from, unsigned long n) {
    look(from, unsigned(n), false, Touch::plain, PC);
    look(to, unsigned(n), true, Touch::plain, PC);
    return std::memmove(to, from, n);
}
HOOK void* __tsan_memset(void* to, int value, unsigned long n) {
    look(to, unsigned(n), true, Touch::plain, PC);
    return std::memset(to, value, n);
}
HOOK void __tsan_init() {}
HOOK void __tsan_func_entry(void*) {}
HOOK void __tsan_func_exit() {}
HOOK void __tsan_vptr_update(void**, void*) {}
HOOK void __tsan_vptr_read(void**) {}
HOOK void __tsan_ignore_thread_begin() {}
HOOK void __tsan_ignore_thread_end() {}

// Atomic operations are these calls altogether.
#define RAYLAB_ATOMIC_HOOKS(bits, T)                                                               \
    HOOK T __tsan_atomic##bits##_load(const volatile T* p, int) {                                  \
        look(const_cast<const T*>(p), bits / 8, false, Touch::atomic, PC);                         \
        return __atomic_load_n(p, __ATOMIC_SEQ_CST);                                               \
    }                                                                                              \
    HOOK void __tsan_atomic##bits##_store(volatile T* p, T v, int) {                               \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        __atomic_store_n(p, v, __ATOMIC_SEQ_CST);                                                  \
    }                                                                                              \
    HOOK T __tsan_atomic##bits##_exchange(volatile T* p, T v, int) {                               \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_exchange_n(p, v, __ATOMIC_SEQ_CST);                                        \
    }                                                                                              \
    HOOK T __tsan_atomic##bits##_fetch_add(volatile T* p, T v, int) {                              \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_fetch_add(p, v, __ATOMIC_SEQ_CST);                                         \
    }                                                                                              \
    HOOK T __tsan_atomic##bits##_fetch_sub(volatile T* p, T v, int) {                              \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_fetch_sub(p, v, __ATOMIC_SEQ_CST);                                         \
    }                                                                                              \
    HOOK T __tsan_atomic##bits##_fetch_and(volatile T* p, T v, int) {                              \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_fetch_and(p, v, __ATOMIC_SEQ_CST);                                         \
    }                                                                                              \
    HOOK T __tsan_atomic##bits##_fetch_or(volatile T* p, T v, int) {                               \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_fetch_or(p, v, __ATOMIC_SEQ_CST);                                          \
    }                                                                                              \
    HOOK T __tsan_atomic##bits##_fetch_xor(volatile T* p, T v, int) {                              \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_fetch_xor(p, v, __ATOMIC_SEQ_CST);                                         \
    }                                                                                              \
    HOOK int __tsan_atomic##bits##_compare_exchange_strong(volatile T* p, T* c, T v, int, int) {   \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_compare_exchange_n(p, c, v, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);    \
    }                                                                                              \
    HOOK int __tsan_atomic##bits##_compare_exchange_weak(volatile T* p, T* c, T v, int, int) {     \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        return __atomic_compare_exchange_n(p, c, v, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);    \
    }                                                                                              \
    HOOK T __tsan_atomic##bits##_compare_exchange_val(volatile T* p, T c, T v, int, int) {         \
        look(const_cast<const T*>(p), bits / 8, true, Touch::atomic, PC);                          \
        __atomic_compare_exchange_n(p, &c, v, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);          \
        return c;                                                                                  \
    }
RAYLAB_ATOMIC_HOOKS(8, unsigned char)
RAYLAB_ATOMIC_HOOKS(16, unsigned short)
RAYLAB_ATOMIC_HOOKS(32, unsigned)
RAYLAB_ATOMIC_HOOKS(64, unsigned long)
#undef RAYLAB_ATOMIC_HOOKS

HOOK void __tsan_atomic_thread_fence(int) { raylab::simt::watch::Watcher::get().fence(); }
HOOK void __tsan_atomic_signal_fence(int) { raylab::simt::watch::Watcher::get().fence(); }
