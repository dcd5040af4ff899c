#include "common/simt/watch/shadow.h"

#include "common/simt/engine/report.h"

#include <cstring>
#include <sys/mman.h>

#if !defined(MAP_NORESERVE) // of macOS, which reserves nothing anyway
#define MAP_NORESERVE 0
#endif

namespace raylab::simt::watch {

void* map_memory(size_t bytes) {
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED)
        end_with_message("error: no address space for the watch: " + std::to_string(bytes >> 20) +
                         " MiB are wanted\n  to do: raise the limit (ulimit -v), or run without "
                         "--machine watch");
    return memory;
}

ByteBits::ByteBits(size_t bytes)
    : bits_(static_cast<uint8_t*>(map_memory(bytes / 8 + 1))), size_(bytes) {}

void ByteBits::set(size_t first, size_t bytes, bool value) {
    size_t i = first;
    const size_t end = first + bytes < size_ ? first + bytes : size_;
    const auto one = [&] {
        const uint8_t bit = uint8_t(1u << i % 8);
        bits_[i / 8] = value ? uint8_t(bits_[i / 8] | bit) : uint8_t(bits_[i / 8] & ~bit);
        ++i;
    };
    while (i < end && i % 8) one();
    if (i < end) std::memset(bits_ + i / 8, value ? 0xff : 0, (end - i) / 8);
    i += i < end ? (end - i) / 8 * 8 : 0;
    while (i < end) one();
}

Range::Range(uintptr_t first, size_t range_bytes, Memory kind)
    : begin(first), bytes(range_bytes), memory(kind), allowed(range_bytes), written(range_bytes),
      words(static_cast<Word*>(map_memory((range_bytes / 4 + 1) * sizeof(Word)))),
      marks(static_cast<Stamp*>(map_memory((range_bytes / 4 + 1) * sizeof(Stamp)))) {}

void Range::forget_marks() {
    madvise(marks, (bytes / 4 + 1) * sizeof(Stamp), MADV_DONTNEED); // they are 0 again
}

Word& Range::byte_at(size_t word, int byte) {
    auto found = split.find(word);
    if (found == split.end()) {
        found = split.emplace(word, std::array<Word, 4>{}).first;
        found->second.fill(words[word]);
        words[word].is_split = true;
    }
    return found->second[size_t(byte)];
}

} // namespace raylab::simt::watch
