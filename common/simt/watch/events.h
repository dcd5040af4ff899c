// What the engine tells the watch (watcher.h); nothing in a build that is not watched.
#pragma once

#include "common/simt/launch.h"

#include <optional>
#include <string>

#if defined(RAYLAB_CHECK_WATCH)
#include "common/simt/watch/watcher.h"
#endif

namespace raylab::simt::watch {

#if defined(RAYLAB_CHECK_WATCH)
inline constexpr bool is_on = true;
inline void begin_launch(const Launch& launch, bool prints) {
    Watcher::get().begin_launch(launch, prints);
}
inline void end_launch() { Watcher::get().end_launch(); }
inline void begin_block(uint32_t block, int threads, void* shared, size_t bytes) {
    Watcher::get().begin_block(block, threads, shared, bytes);
}
inline void pause() { Watcher::get().pause(); }
inline void go_on(int thread) { Watcher::get().go_on(thread); }
inline void barrier() { Watcher::get().barrier(); }
inline void meet(int warp, unsigned members) { Watcher::get().meet(warp, members); }
inline void add_stack(const void* bottom, size_t bytes) { Watcher::get().add_stack(bottom, bytes); }
inline bool has_told(const std::string& report) { return Watcher::get().has_told(report); }
inline void wrote(const void* memory, size_t bytes) { Watcher::get().wrote(memory, bytes); }
// A copy of the runtime, or where `from` is null a memset; without a stream the call waits for it.
inline void copied(const void* to, const void* from, size_t bytes, const Where& where,
                   const std::optional<cudaStream_t>& stream) {
    Watcher::get().copied({to, from, bytes, where, stream});
}
// Changes what is known of the order of streams, events and host code (StreamOrder).
template <class Change> inline void order(Change change) {
    Watcher::get().concurrency().order(change);
}
#else
inline constexpr bool is_on = false;
inline void begin_launch(const Launch&, bool) {}
inline void end_launch() {}
inline void begin_block(uint32_t, int, void*, size_t) {}
inline void pause() {}
inline void go_on(int) {}
inline void barrier() {}
inline void meet(int, unsigned) {}
inline void add_stack(const void*, size_t) {}
inline bool has_told(const std::string&) { return false; }
inline void wrote(const void*, size_t) {}
inline void copied(const void*, const void*, size_t, const Where&,
                   const std::optional<cudaStream_t>&) {}
template <class Change> inline void order(Change) {}
#endif

// While one of these lives, what its thread does is the engine's.
class Pause {
  public:
#if defined(RAYLAB_CHECK_WATCH)
    Pause() : thread_(Watcher::get().thread()) { pause(); }
    ~Pause() {
        if (thread_ >= 0) go_on(thread_);
    }

  private:
    int thread_;
#else
    Pause() {}
#endif
};

} // namespace raylab::simt::watch
