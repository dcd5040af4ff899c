// The file of findings; see findings.h. It is opened for appending and every line is written at
// once: whatever ends the program, the lines before are there.
#include "common/simt/engine/findings.h"

#include "common/simt/engine/sanitizer.h"

#include <atomic>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

namespace raylab::simt {

namespace {

struct Counts {
    std::atomic<std::uint64_t> launches{0}, threads{0}, allocations{0}, bytes{0};
};

class FindingsOut {
  public:
    FindingsOut() {
        if (const char* path = std::getenv("RAYLAB_FINDINGS"); path && *path)
            file_ = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    }
    void write(std::string line) {
        if (file_ < 0) return;
        line += '\n';
        // Full disk or not, the program goes on; the reader misses the line, and the summary.
        [[maybe_unused]] const ssize_t written = ::write(file_, line.data(), line.size());
    }
    bool is_open() const { return file_ >= 0; }

  private:
    int file_ = -1;
};

// Neither is ever destroyed: the last findings are leaks, reported when all else is gone.
FindingsOut& out() {
    static auto* out = new FindingsOut;
    return *out;
}

Counts& counts() {
    static auto* counts = new Counts;
    return *counts;
}

std::string mode() {
    if (const char* mode = std::getenv("RAYLAB_MODE"); mode && *mode) return mode;
#if defined(RAYLAB_CHECK_ADDRESS)
    return "bounds";
#elif defined(RAYLAB_CHECK_THREAD)
    return "races";
#else
    return "plain";
#endif
}

} // namespace

void record(Finding finding) {
    if (!out().is_open()) return;
    if (finding.mode.empty()) finding.mode = mode();
    out().write(to_json_line(finding));
}

void record(const AccessCost& cost) { out().write(to_json_line(cost)); }

bool records_findings() { return out().is_open(); }

// Written again whenever the number of launches has doubled, for programs that are killed.
void count_launch(std::uint64_t threads) {
    counts().threads += threads;
    const std::uint64_t launches = ++counts().launches;
    static const bool at_exit = std::atexit(write_summary) == 0;
    if (!at_exit || (launches & (launches - 1)) == 0) write_summary();
}

void count_allocation(std::uint64_t bytes) {
    ++counts().allocations;
    counts().bytes += bytes;
}

void write_summary() {
    if (!out().is_open()) return;
    out().write(to_json_line(
        RunSummary{counts().launches, counts().threads, counts().allocations, counts().bytes}));
}

} // namespace raylab::simt
