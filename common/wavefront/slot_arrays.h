// Arrays of device memory with an entry for each slot of a pool, declared once.
//
// A struct of such arrays derives from SlotArrays and deals each of them out where it is declared:
//
//     struct Pool : SlotArrays {
//         using SlotArrays::SlotArrays;
//         int* bounce = deal();         // an entry a slot
//         PendingRay* stack = deal(23); // 23 entries a slot
//     };
//
// C++ initialises members in the order of their declarations, and deal() learns the type of its
// array from the pointer that it becomes. The struct itself is plain pointers, as kernels want it.
#pragma once

#include "common/device/device_array.h"

#include <cstddef>

namespace raylab {

// The memory of the arrays. Each is an allocation of its own, so that a build that checks every
// access sees where one ends.
class SlotMemory {
  public:
    explicit SlotMemory(int slots) : slots_(slots) {}

    int slots() const { return slots_; }

    // All bytes zero. bytes: for each slot.
    void* deal(std::size_t bytes) {
        arrays_.emplace_back(bytes * static_cast<std::size_t>(slots_));
        return arrays_.back().data();
    }

  private:
    int slots_;
    std::vector<DeviceArray<std::byte>> arrays_;
};

struct SlotArrays {
    int capacity;                   // slots
    std::size_t bytes_per_slot = 0; // of all arrays together

    // Without memory all arrays are null: good for counting their bytes.
    constexpr explicit SlotArrays(SlotMemory* memory)
        : capacity(memory == nullptr ? 0 : memory->slots()), memory_(memory) {}

  protected:
    // What becomes an array of whatever type the pointer has that it is assigned to.
    struct Dealt {
        SlotArrays& arrays;
        int entries; // for each slot

        template <class T> constexpr operator T*() const {
            const std::size_t bytes = sizeof(T) * static_cast<std::size_t>(entries);
            arrays.bytes_per_slot += bytes;
            if (arrays.memory_ == nullptr || entries == 0) return nullptr;
            return static_cast<T*>(arrays.memory_->deal(bytes));
        }
    };

    // entries: for each slot; 0: no array, a null pointer.
    constexpr Dealt deal(int entries = 1) { return {*this, entries}; }

  private:
    SlotMemory* memory_; // the host's: means nothing to a kernel
};

} // namespace raylab
