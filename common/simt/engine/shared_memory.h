// A block's dynamic shared memory, which ends where the memory that may be touched ends: a kernel
// that writes past it stops there, and never reaches the engine.
#pragma once

#include "common/simt/engine/sanitizer.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace raylab::simt {

class SharedMemory {
  public:
    SharedMemory() = default;
    ~SharedMemory();
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;

    // From now on `bytes` bytes, aligned to 16; in a check build they are NaNs. False where the
    // system gives no more memory.
    bool resize(size_t bytes);

    void* data() const { return data_; }
    size_t bytes() const { return bytes_; }

    // Whether this address is in the forbidden part after the end.
    bool is_overrun(const void* address) const;

  private:
    void* data_ = nullptr;
    size_t bytes_ = 0;
#if defined(RAYLAB_CHECK_ADDRESS)
    std::unique_ptr<char[]> heap_; // AddressSanitizer guards the ends of what is on the heap
#else
    char* end_ = nullptr; // of what may be touched
#endif
};

} // namespace raylab::simt
