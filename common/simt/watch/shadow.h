// What the watch remembers of memory: per byte whether it may be touched and whether it was
// written, per word of four bytes who touched it last.
//
// A word holds the last writer and two readers. Two suffice: a writer that is not ordered after all
// readers is, with two from different warps or blocks, hardly ever ordered after both. Where
// threads touch single bytes of a word, the word is split into four.
#pragma once

#include "common/simt/watch/quiet_reads.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace raylab::simt::watch {

enum class Touch : uint8_t { plain, volatile_, atomic }; // how a place is touched

inline bool is_atomic(Touch touch) { return touch == Touch::atomic; }

struct Access {
    Task task;
    Time time;
    uint32_t launch;
    uint32_t site : 24; // of RaceBook::site(), 0: none
    Touch touch : 7;
    bool has_read : 1; // a write: its thread has read the place shortly before
};
static_assert(sizeof(Access) == 16, "a word of memory costs three of these");

struct Word {
    Access writer{}, readers[2]{};
    bool is_split = false;
};

// Bits, one for each byte of a range.
class ByteBits {
  public:
    explicit ByteBits(size_t bytes);
    void set(size_t first, size_t bytes, bool value);
    // Of the four bytes from 4 * word on.
    unsigned of_word(size_t word) const { return bits_[word / 2] >> (word % 2 * 4) & 15u; }
    void add(size_t word, unsigned bytes) { bits_[word / 2] |= uint8_t(bytes << (word % 2 * 4)); }

  private:
    uint8_t* bits_; // mapped memory: what nobody touches costs nothing
    size_t size_;
};

enum class Memory { global, shared, symbol };

// A range of addresses that is watched. Ranges live as long as the program.
struct Range {
    Range(uintptr_t first, size_t range_bytes, Memory kind);
    bool has(uintptr_t address) const { return address - begin < bytes; }
    MarkedSpan marked() const { return {{begin, bytes}, marks}; }
    void forget_marks();
    // The part of a split word: its byte `byte`.
    Word& byte_at(size_t word, int byte);

    uintptr_t begin; // a multiple of 16
    size_t bytes;
    Memory memory;
    ByteBits allowed, written;
    Word* words;  // mapped
    Stamp* marks; // likewise, a word each (quiet_reads.h)
    std::unordered_map<size_t, std::array<Word, 4>> split;
};

// Zeroed memory that becomes real where it is touched.
void* map_memory(size_t bytes);

} // namespace raylab::simt::watch
