// Fibers and their stacks; see fiber.h.
#include "common/simt/engine/fiber.h"

#include "common/simt/engine/switch.h"
#include "common/simt/watch/events.h"

#include <cstdlib>
#include <sys/mman.h>
#include <unistd.h>

namespace raylab::simt {

#if defined(RAYLAB_CHECK_ADDRESS)

void switch_fiber(Fiber& from, Fiber& to, bool from_ends) {
    __sanitizer_start_switch_fiber(from_ends ? nullptr : &from.announced, to.bottom, to.bytes);
    raylab_simt_switch(&from.context, to.context);
    __sanitizer_finish_switch_fiber(from.announced, nullptr, nullptr);
}

void enter_fiber() { __sanitizer_finish_switch_fiber(nullptr, nullptr, nullptr); }

Fiber native_fiber() {
    Fiber fiber;
#if defined(__APPLE__)
    fiber.bytes = pthread_get_stacksize_np(pthread_self());
    fiber.bottom = static_cast<char*>(pthread_get_stackaddr_np(pthread_self())) - fiber.bytes;
#else
    void* bottom = nullptr;
    pthread_attr_t attributes;
    pthread_getattr_np(pthread_self(), &attributes);
    pthread_attr_getstack(&attributes, &bottom, &fiber.bytes);
    pthread_attr_destroy(&attributes);
    fiber.bottom = static_cast<char*>(bottom);
#endif
    return fiber;
}

static void* announce_fiber() { return nullptr; }
static void revoke_fiber(void*) {}

#elif defined(RAYLAB_CHECK_THREAD)

// Without synchronisation: that the engine runs A before B means nothing in the kernel.
void switch_fiber(Fiber& from, Fiber& to, bool) {
    __tsan_switch_to_fiber(to.announced, __tsan_switch_to_fiber_no_sync);
    raylab_simt_switch(&from.context, to.context);
}

void enter_fiber() {}

Fiber native_fiber() {
    Fiber fiber;
    fiber.announced = __tsan_get_current_fiber();
    return fiber;
}

static void* announce_fiber() { return __tsan_create_fiber(0); }
static void revoke_fiber(void* fiber) { __tsan_destroy_fiber(fiber); }

#else

void switch_fiber(Fiber& from, Fiber& to, bool) { raylab_simt_switch(&from.context, to.context); }
void enter_fiber() {}
Fiber native_fiber() { return {}; }
static void* announce_fiber() { return nullptr; }
static void revoke_fiber(void*) {}

#endif

static size_t page_bytes() {
    static const size_t bytes = size_t(sysconf(_SC_PAGESIZE));
    return bytes;
}

#if !defined(MAP_STACK) // of macOS, and of no effect on Linux
#define MAP_STACK 0
#endif

static char* allocate_stack(size_t bytes) {
    constexpr size_t guard = stack_guard_bytes;
    void* memory = mmap(nullptr, guard + bytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
    if (memory == MAP_FAILED) return nullptr;
    if (mprotect(memory, guard, PROT_NONE) != 0) {
        munmap(memory, guard + bytes);
        return nullptr;
    }
    return static_cast<char*>(memory) + guard;
}
static void free_stack(char* bottom, size_t bytes) {
    munmap(bottom - stack_guard_bytes, stack_guard_bytes + bytes);
}

FiberPool::FiberPool(size_t stack_bytes)
    : stack_bytes_((stack_bytes + page_bytes() - 1) / page_bytes() * page_bytes()) {}

FiberPool::~FiberPool() {
    for (auto& fiber : all_) {
        allow(fiber->bottom, fiber->bytes);
        revoke_fiber(fiber->announced);
        free_stack(fiber->bottom, fiber->bytes);
    }
}

bool FiberPool::add() {
    char* bottom = allocate_stack(stack_bytes_);
    if (!bottom) return false;
    watch::add_stack(bottom, stack_bytes_);
    // All stacks are aligned alike, and the frames at their tops would compete for the same few
    // cache lines. So each starts a little lower than the one before it.
    size_t stagger = all_.size() % 25 * 5 * 64;
    all_.push_back(std::make_unique<Fiber>());
    *all_.back() = {nullptr, bottom, stack_bytes_, bottom + stack_bytes_ - stagger,
                    announce_fiber()};
    free_.push_back(all_.back().get());
    return true;
}

bool FiberPool::reserve(size_t count) {
    while (free_.size() < count)
        if (!add()) return false;
    return true;
}

Fiber* FiberPool::take() {
    if (!reserve(1)) return nullptr;
    Fiber* fiber = free_.back();
    free_.pop_back();
    fiber->context = raylab_simt_prepare(fiber->top, size_t(fiber->top - fiber->bottom));
    return fiber;
}

void FiberPool::reclaim() {
    free_.clear();
    for (auto& fiber : all_) {
        allow(fiber->bottom, fiber->bytes);
        free_.push_back(fiber.get());
    }
}

} // namespace raylab::simt
