// What the program's exit status means. A failure of the tool is never a student's fault.
#pragma once

namespace raylab {

enum class ExitCode : int {
    success = 0,       // done, passed
    judged_failed = 1, // judged, and failed
    bad_usage = 2,     // wrong usage or wrong input
    tool_failed = 3,   // raylab itself, or the machine, failed
};

} // namespace raylab
