// Accesses that streams leave unordered: of two launches, of a launch and an asynchronous copy, and
// of host code while either may still be at work.
//
// Words remember the launch that touched them last (shadow.h), of any stream; copies are few and
// are kept as ranges. Everything is done at once on this machine (runtime.h), so only the order
// that the program asked for is looked at (stream_order.h). Calls of host code may come from any
// thread of the operating system, hence the lock.
#pragma once

#include "common/simt/finding.h"
#include "common/simt/launch.h"
#include "common/simt/watch/race_book.h"
#include "common/simt/watch/shadow.h"
#include "common/simt/watch/stream_order.h"

#include <mutex>
#include <optional>
#include <unordered_set>

namespace raylab::simt::watch {

// A copy, or a memset where `from` is null.
struct CopyCall {
    const void *to, *from;
    size_t bytes;
    Where where;
    std::optional<StreamOrder::Stream> stream; // none: the call waits for it
};

class Concurrency {
  public:
    explicit Concurrency(RaceBook& sites) : sites_(sites) {}

    Operation begin_launch(const Launch& launch);
    void copy(const CopyCall& call, Range& arena);

    template <class Change> void order(Change change) {
        std::lock_guard lock(mutex_);
        change(order_);
        forget_what_ended();
    }

    // Whether an access of the launch that runs must be looked at.
    bool concerns_launch() const { return !order_.running_knows_all(); }
    void kernel_access(const Word& word, uintptr_t address, unsigned bytes, bool writes,
                       Touch touch, Pc pc);

    bool concerns_host() const { return !order_.host_knows_all(); }
    void host_access(Range& arena, uintptr_t address, unsigned bytes, bool writes, Pc pc);

  private:
    struct PendingCopy {
        Operation operation;
        uintptr_t begin;
        size_t bytes;
        bool writes; // this range
    };
    struct Doer;

    void look_at_range(const Doer& doer, Range& arena, uintptr_t begin, size_t bytes, bool writes);
    void compare(const Doer& doer, const Word& word, bool writes);
    void compare_copies(const Doer& doer, uintptr_t begin, size_t bytes, bool writes);
    void say(const Doer& doer, bool writes, const OperationName& before, bool before_wrote,
             const SourcePlace& before_place);
    void forget_what_ended();

    std::mutex mutex_;
    RaceBook& sites_;
    StreamOrder order_;
    std::vector<PendingCopy> copies_; // that host code does not know to have ended
    std::unordered_set<Pc> told_;     // statements of host code
};

} // namespace raylab::simt::watch
