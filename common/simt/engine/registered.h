// Host memory that the program has lent to the device: cudaHostRegister().
#pragma once

namespace raylab::simt {

bool is_registered(const void* pointer);

} // namespace raylab::simt
