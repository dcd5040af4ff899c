// Host memory that the program has lent to the device: cudaHostRegister().
#pragma once

namespace raylab::simt {

// Also any pointer, after take_any_memory() (api/managed.h).
bool is_registered(const void* pointer);

} // namespace raylab::simt
