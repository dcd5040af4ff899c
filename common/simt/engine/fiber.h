// A fiber: a stack, and where on it to go on. And the pool that fibers come from.
#pragma once

#include "common/simt/engine/sanitizer.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace raylab::simt {

struct Fiber {
    void* context = nullptr;   // where to go on
    char* bottom = nullptr;    // lowest usable address of the stack
    size_t bytes = 0;          // from there up
    char* top = nullptr;       // where a fresh start begins
    void* announced = nullptr; // AddressSanitizer's fake stack, or ThreadSanitizer's fiber
};

// Leaves `from`, which is running, and goes on in `to`. `from_ends`: nobody will come back.
void switch_fiber(Fiber& from, Fiber& to, bool from_ends = false);

// To be called first on a fresh fiber.
void enter_fiber();

// Describes the calling operating system thread's own stack.
Fiber native_fiber();

// Below each stack lie as many bytes that may not be touched: more than most local arrays have.
inline constexpr size_t stack_guard_bytes = size_t(64) << 10;

// The fibers of one worker.
class FiberPool {
  public:
    explicit FiberPool(size_t stack_bytes);
    ~FiberPool();
    FiberPool(const FiberPool&) = delete;
    FiberPool& operator=(const FiberPool&) = delete;

    // A fiber that starts afresh, or null where the system gives no more memory.
    Fiber* take();

    // Takes a fiber back, which may go on running until the next take().
    void give(Fiber* fiber) { free_.push_back(fiber); }

    // Makes sure that `count` fibers are there to be taken.
    bool reserve(size_t count);

    // Takes all back, wherever they are stuck.
    void reclaim();

  private:
    bool add();

    size_t stack_bytes_;
    std::vector<std::unique_ptr<Fiber>> all_;
    std::vector<Fiber*> free_;
};

} // namespace raylab::simt
