// Places by file and line; see groups/site_of.h.
#include "common/simt/groups/site_of.h"

#include <atomic>
#include <map>
#include <tuple>

namespace raylab::simt {

namespace {

// A lock of which ThreadSanitizer does not know: it would take it for an order between the blocks.
class Spin {
  public:
    void lock() {
        while (taken_.test_and_set(std::memory_order_acquire)) {
        }
    }
    void unlock() { taken_.clear(std::memory_order_release); }

  private:
    std::atomic_flag taken_;
};

struct Table {
    Spin spin;
    std::map<std::tuple<const char*, const char*, int>, Site> sites; // whose addresses stay
};

// Never destroyed: a report may name its places to the end.
Table& table() {
    static auto* table = new Table;
    return *table;
}

constinit thread_local const Site* latest[64] = {};

} // namespace

const Site& site_of(const char* operation, const Where& where) {
    const Site*& guess = latest[unsigned(where.line) % 64];
    if (guess && guess->operation == operation && guess->file == where.file &&
        guess->line == where.line)
        return *guess;
    table().spin.lock();
    Site site{operation, where.file, where.line};
    guess = &table().sites.insert({{operation, where.file, where.line}, site}).first->second;
    table().spin.unlock();
    return *guess;
}

} // namespace raylab::simt
