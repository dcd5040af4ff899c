// Which names a submission of lab 02 may define and use.
#include "grader/grading/allowed_symbols.h"

#include <gtest/gtest.h>

namespace raylab::grading {
namespace {

TEST(AllowedSymbols, WhatComputesMayBeUsed) {
    for (const char* name : {"sinf", "pow", "memcpy", "printf", "_Znwm", "_ZdlPvm", "__cxa_throw",
                             "_ZSt17__throw_bad_allocv", "_ZNSt6vectorIiSaIiEE9push_backERKi",
                             "_ZN6raylab9intersectEv", "_ZN3fmt2v96formatEv", "cudaMalloc"})
        EXPECT_TRUE(may_use(name)) << name;
}

TEST(AllowedSymbols, WhatReachesOutMayNot) {
    for (const char* name : {"_exit",
                             "exit",
                             "fork",
                             "kill",
                             "open",
                             "read",
                             "write",
                             "system",
                             "dlopen",
                             "mmap",
                             "ptrace",
                             "syscall",
                             "socket",
                             "getenv",
                             "pthread_create",
                             "longjmp",
                             "raise",
                             "_ZN7testing8UnitTest11GetInstanceEv",
                             "_ZNK7testing10TestResult6FailedEv",
                             "_ZN6raylab4task6expectEv",
                             "_ZN6raylab4simt5blockEv",
                             "_ZNSt10filesystem6existsEv",
                             "_ZNSt14basic_ifstreamIcSt11char_traitsIcEEC1Ev",
                             "_ZNSt6thread15_M_start_threadEv"})
        EXPECT_FALSE(may_use(name)) << name;
}

TEST(AllowedSymbols, OnlyTheLabsOwnMayBeDefined) {
    EXPECT_TRUE(may_define("_ZN6raylab5lab0210trace_pathEv", "02"));
    EXPECT_TRUE(may_define_weakly("_ZZN6raylab5lab0210trace_pathEvE5cache", "02"));
    EXPECT_TRUE(may_define_weakly("_ZNSt6vectorIiSaIiEE9push_backERKi", "02"));
    for (const char* name : {"main", "malloc", "_Znwm", "_ZN7testing4TestD2Ev",
                             "_ZN6raylab7developEv", "_ZN6raylab5lab0310trace_pathEv"})
        EXPECT_FALSE(may_define(name, "02")) << name;
    for (const char* name : {"_ZN6raylab4task6expectEv", "_ZN7testing4TestD2Ev", "memcmp"})
        EXPECT_FALSE(may_define_weakly(name, "02")) << name;
}

} // namespace
} // namespace raylab::grading
