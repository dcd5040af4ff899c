// Building a tree on several threads: the cuts at its top make subtrees, and each is a task.
//
// A thread always takes the largest task: if a large one began last, all other threads would wait
// for it. Which thread builds which subtree changes from run to run. So every task writes to memory
// of its own, and the driver (builder/driver.h) puts the subtrees together at the end. Wald, On
// Fast Construction of SAH-based Bounding Volume Hierarchies, 2007, section 4.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace raylab::lab04 {

// Tasks that may add tasks.
class BuildTasks {
  public:
    // size: of the work; large tasks begin first. May be called by tasks, on any thread.
    void add(std::size_t size, std::function<void()> work);

    // Returns when all tasks are done, by so many threads, this one among them. Throws what the
    // first task that failed has thrown, or std::system_error if a thread cannot be started; tasks
    // that have not begun by then are dropped.
    void run(int threads);

  private:
    struct Task {
        std::size_t size;
        std::function<void()> work;
        bool operator<(const Task& other) const { return size < other.size; }
    };
    void take_part();

    std::mutex mutex_; // of all below
    std::condition_variable changed_;
    std::vector<Task> waiting_; // a heap, the largest first
    int running_ = 0;
    std::exception_ptr failure_;
};

// Threads asked for, or one per core where 0 are.
int threads_or_cores(int threads);

// Builds what hangs below `root`. A Piece of the tree has
//     size()   of its work
//     cut()    cuts it in two pieces, half[0] and half[1]; false if it is better left whole
//     build()  builds all of it
//     half[2]  pointers to pieces; none in one that is whole
// Pieces below are cut and built at the same time, and must not know of each other.
template <class Piece> void build_in_pieces(Piece& root, int threads) {
    constexpr std::size_t least = 1024; // below that, sharing costs more than it brings
    constexpr int pieces_per_thread = 8;
    threads = threads_or_cores(threads);
    const std::size_t whole =
        threads == 1 ? root.size() : std::max(least, root.size() / (pieces_per_thread * threads));
    if (root.size() <= whole) return root.build();
    BuildTasks tasks;
    const std::function<void(Piece&)> grow = [&](Piece& piece) {
        if (piece.size() <= whole || !piece.cut()) return piece.build();
        for (const auto& half : piece.half) tasks.add(half->size(), [&] { grow(*half); });
    };
    tasks.add(root.size(), [&] { grow(root); });
    tasks.run(threads);
}

} // namespace raylab::lab04
