// Memory of whole pages, with a gap before and behind it that no one may touch.
#pragma once

#include <cstddef>

namespace raylab::simt {

// The memory ends at the gap behind it, but for what `alignment`, a power of 2, asks for. Null
// where the system gives no more, or after some thousands of calls: it counts each gap.
void* take_pages(size_t bytes, size_t alignment);

// Whether take_pages() gave it.
bool give_back_pages(void* pointer);

} // namespace raylab::simt
