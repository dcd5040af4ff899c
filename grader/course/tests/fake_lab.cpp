// A lab's test program with every outcome there is, for verdict_test.cpp.
#include "common/task/facts.h"
#include "common/task/not_implemented.h"

#include <csignal>

namespace raylab {

namespace {

TEST(Right, One) {}
TEST(Right, Two) {}

TEST(Wrong, One) { task::expect_near("the answer", 41, 42, 0.5, "one too few"); }
TEST(Wrong, Two) {}

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

TEST(Throwing, One) { throw std::runtime_error("no such scene"); }

} // namespace

} // namespace raylab
