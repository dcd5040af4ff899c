// What a test's program printed by itself: a student's printf, in a kernel or not.
#pragma once

#include <string>
#include <vector>

namespace raylab {

// The lines between GoogleTest's "[ RUN      ] name" and the end of this test, without those that
// others wrote: GoogleTest (its `failures` are as in its report), a stub, the CPU machine and the
// sanitizers. At most `most` lines of at most 200 bytes; a last one says how many more there were.
std::vector<std::string> said_by_test(const std::string& output, const std::string& name,
                                      const std::vector<std::string>& failures, int most = 20);

} // namespace raylab
