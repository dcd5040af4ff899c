// The watch's findings in words.
#pragma once

#include "common/simt/finding.h"
#include "common/simt/launch.h"
#include "common/simt/watch/block_clock.h"
#include "common/simt/watch/concurrency.h"
#include "common/simt/watch/race_book.h"

#include <utility>
#include <vector>

namespace raylab::simt::watch {

void say_race(const Race& race, const RaceBook& book, const BlockClock& clock,
              const Launch& launch);

// What the running thread did.
void say_out_of_bounds(uintptr_t address, unsigned bytes, bool writes, Pc pc, Memory memory);
// Not said yet: it may turn out to be one end of a race.
Finding uninitialised(uintptr_t address, Pc pc, Memory memory);

// An address that is no device memory: null, host memory, or nothing at all. A GPU would end the
// launch there, and so does this; but returns for what is neither, constants of the program.
void say_strange_address(uintptr_t address, bool writes, Pc pc);

// Host code touches device memory.
void say_host_access(uintptr_t address, bool writes, Pc pc);

// Host code and a kernel use one variable of the program.
void say_host_variable(Pc host, bool host_writes, Pc kernel, bool kernel_writes);

// The running thread touches a local variable of another one.
void say_foreign_local(bool writes, Pc pc);

// The running thread's calls, one of them at `call`, need more than a GPU's stack has.
Finding too_deep(size_t calls, size_t stack_bytes, Pc call);

// Notes a copy to host code of what nobody has written in device memory.
void say_unwritten_copy(const CopyCall& call, const Range& arena);

// The kernel, block and thread that run.
Actor running_actor();

// Variables of the engine that every kernel may read.
std::vector<std::pair<const void*, size_t>> engine_variables();

} // namespace raylab::simt::watch
