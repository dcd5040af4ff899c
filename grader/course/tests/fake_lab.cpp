// A lab's test program with every outcome there is, for verdict_test.cpp.
#include "common/task/facts.h"
#include "common/task/not_implemented.h"

#include <csignal>
#include <cstdlib>
#include <fstream>

namespace raylab {

namespace {

TEST(Right, One) {}
TEST(Right, Two) {}

TEST(Wrong, One) { task::expect_near("the answer", 41, 42, 0.5, "one too few"); }
TEST(Wrong, Two) {}

// Passes by its own words; the machine that watches every access has seen a race, and a harmless
// one.
TEST(Watched, One) {
    std::ofstream out(std::getenv("RAYLAB_FINDINGS"));
    for (const char* severity : {"error", "note"})
        out << R"({"kind": "race", "mode": "watch", "severity": ")" << severity
            << R"(", "file": "labs/07_fake/a.cu", "line": 12, "message": "a race", "advice": "a barrier"})"
            << "\n";
}

// What the CPU machine leaves behind after a kernel.
void launch() {
    std::ofstream(std::getenv("RAYLAB_FINDINGS"))
        << R"({"launches": 1, "threads": 32, "allocations": 0, "bytes": 0})"
        << "\n";
}
bool in_reverse() { return std::string(std::getenv("RAYLAB_ORDER")) == "reverse"; }

TEST(Ordered, One) {
    launch();
    task::expect(!in_reverse(), "a sum is missing");
}
TEST(Unordered, One) { launch(); }
TEST(WithoutKernel, One) { task::expect(!in_reverse(), "it was run again"); }

TEST(Stubbed, One) {
    not_implemented("7.3", "f()", "/some/where/labs/07_fake/a.cpp", 12);
    task::expect(false, "a fact that the stub explains");
}

TEST(Half, Stubbed) {
    not_implemented("7.4", "g()", "/some/where/labs/07_fake/a.cpp", 34);
    task::expect(false, "a fact that the stub explains");
}
TEST(Half, Wrong) { task::expect(false, "a fact of the other half"); }

TEST(Needing, One) {
    not_implemented("7.3", "f()", "/some/where/labs/07_fake/a.cpp", 12);
    task::expect(false, "a fact that the stub of another task explains");
}

TEST(Crashing, One) { std::raise(SIGSEGV); }
TEST(Dividing, One) { std::raise(SIGFPE); }

TEST(Leaving, One) { std::exit(0); }

TEST(Skipping, One) { GTEST_SKIP() << "not here"; }

TEST(Disabled, DISABLED_One) {}

TEST(WithoutGpu, One) {
    task::expect(false, "launch failed\nno NVIDIA GPU or driver was found on this machine");
}

TEST(Talking, One) {
    for (int i = 0; i < 1000; ++i) std::fputs(std::string(10000, '.').c_str(), stdout);
}

TEST(Printing, One) {
    std::puts("thread 3: 0.5");
    task::expect(false, "a fact");
}

// Before any test begins.
const bool ended = [] {
    const char* how = std::getenv("RAYLAB_FAKE_LAB_ENDS");
    if (how && *how == '0') std::exit(0);
    if (how) std::raise(SIGSEGV);
    return false;
}();

TEST(Throwing, One) { throw std::runtime_error("no such scene"); }

} // namespace

} // namespace raylab
