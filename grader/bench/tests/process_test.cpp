// Programs that end well, badly, by a signal, never, or do not exist.
#include "grader/bench/process.h"

#include <gmock/gmock.h>

namespace raylab::bench {
namespace {

using testing::HasSubstr;

ProcessResult shell(const std::string& script, double limit = 10) {
    return run_process({"sh", "-c", script}, limit);
}

TEST(Process, GivesOutputAndExitStatus) {
    const ProcessResult result = shell("echo to; echo fro >&2");
    EXPECT_TRUE(result.succeeded());
    EXPECT_EQ(result.output, "to\nfro\n");
    const ProcessResult failed = shell("echo 'Error: no wine'; echo quit; echo; exit 3");
    EXPECT_FALSE(failed.succeeded());
    EXPECT_EQ(why_failed(failed), "exit status 3: Error: no wine");
    EXPECT_EQ(why_failed(shell("echo last words; exit 1")), "exit status 1: last words");
    EXPECT_EQ(why_failed(shell("echo 'ImportError: x'; echo 'Error: script failed'; exit 1")),
              "exit status 1: ImportError: x");
    EXPECT_THAT(why_failed(shell("kill -SEGV $$")), HasSubstr("signal 11"));
}

TEST(Process, IsStoppedAtItsLimitWithItsChildren) {
    const ProcessResult result = shell("sleep 30 & sleep 30", 0.2);
    EXPECT_TRUE(result.timed_out);
    EXPECT_LT(result.seconds, 5);
    EXPECT_THAT(why_failed(result), HasSubstr("timed out"));
}

TEST(Process, ThatDoesNotExistIsSaid) {
    const ProcessResult result = run_process({"/no/such/program"}, 1);
    EXPECT_FALSE(result.succeeded());
    EXPECT_THAT(why_failed(result), HasSubstr("could not be started: No such file"));
}

} // namespace
} // namespace raylab::bench
