// Threads that are joined at the end of their scope, also if one of them could not be started:
// std::jthread, which Apple's library does not have yet.
#pragma once

#include <thread>
#include <utility>
#include <vector>

namespace raylab {

class JoinedThreads {
  public:
    JoinedThreads() = default;
    ~JoinedThreads() {
        for (std::thread& thread : threads_) thread.join();
    }
    JoinedThreads(const JoinedThreads&) = delete;
    JoinedThreads& operator=(const JoinedThreads&) = delete;

    template <class Work> void start(Work work) { threads_.emplace_back(std::move(work)); }

  private:
    std::vector<std::thread> threads_;
};

} // namespace raylab
