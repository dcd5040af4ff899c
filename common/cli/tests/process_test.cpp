// Programs that end well, badly, by a signal, never, or do not exist.
#include "common/cli/process.h"

#include <gmock/gmock.h>

namespace raylab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

ProcessResult shell(const std::string& script, const ProcessOptions& options = {10}) {
    return run_process({"sh", "-c", script}, options);
}

TEST(Process, GivesOutputAndExitStatus) {
    const ProcessResult result = shell("echo to; echo fro >&2");
    EXPECT_TRUE(result.succeeded());
    EXPECT_EQ(result.output, "to\nfro\n");
    EXPECT_EQ(shell("cat; exit 5").exit_code, 5); // its standard input is empty
}

TEST(Process, SaysWhyItFailed) {
    const ProcessResult failed = shell("echo 'Error: no wine'; echo quit; echo; exit 3");
    EXPECT_FALSE(failed.succeeded());
    EXPECT_EQ(why_failed(failed), "exit status 3: Error: no wine");
    EXPECT_EQ(why_failed(shell("echo last words; exit 1")), "exit status 1: last words");
    EXPECT_EQ(why_failed(shell("echo 'ImportError: x'; echo 'Error: script failed'; exit 1")),
              "exit status 1: ImportError: x");
    const ProcessResult crashed = shell("kill -SEGV $$");
    EXPECT_EQ(crashed.signal, 11);
    EXPECT_FALSE(crashed.succeeded());
    EXPECT_THAT(why_failed(crashed), HasSubstr("signal 11"));
}

TEST(Process, RunsInTheFolder) {
    EXPECT_EQ(shell("pwd", {10, "/usr"}).output, "/usr\n");
    EXPECT_FALSE(shell("pwd", {10, "/no/such/folder"}).started);
}

TEST(Process, IsStoppedAtItsLimitWithItsChildren) {
    // The third closes its output: nothing is left to read, and it still has to end.
    for (const char* script : {"sleep 30 & sleep 30", "sleep 30 &", "exec sleep 30 >&- 2>&-"}) {
        const ProcessResult result = shell(script, {0.2});
        EXPECT_TRUE(result.timed_out) << script;
        EXPECT_FALSE(result.succeeded()) << script;
        EXPECT_LT(result.seconds, 10) << script;
        EXPECT_THAT(why_failed(result), HasSubstr("timed out")) << script;
    }
}

// Six times it waits and then works a little: as if other programs kept it from its work.
const char* const kept_waiting = "for i in 1 2 3 4 5 6; do sleep 0.2; "
                                 "j=0; while [ $j -lt 2000 ]; do j=$((j+1)); done; done; echo done";

TEST(Process, ThatIsKeptWaitingHasMoreTime) {
    EXPECT_TRUE(shell(kept_waiting, {.limit_seconds = 0.5}).timed_out);
    const ProcessResult result =
        shell(kept_waiting, {.limit_seconds = 0.5, .limit_on_a_busy_machine = 60});
    EXPECT_FALSE(result.timed_out);
    EXPECT_EQ(result.output, "done\n");
    EXPECT_TRUE(
        shell(kept_waiting, {.limit_seconds = 0.5, .limit_on_a_busy_machine = 0.6}).timed_out);
}

TEST(Process, WhoseLoopNeverEndsOrThatWaitsForItselfIsStopped) {
    for (const char* script : {"while :; do :; done", "exec sleep 100"}) {
        const ProcessResult result =
            shell(script, {.limit_seconds = 0.5, .limit_on_a_busy_machine = 60});
        EXPECT_TRUE(result.timed_out) << script;
        EXPECT_LT(result.seconds, 30) << script;
    }
}

TEST(Process, ThatDoesNotExistIsSaid) {
    const ProcessResult result = run_process({"no-such-program-at-all"}, {1});
    EXPECT_FALSE(result.succeeded());
    EXPECT_THAT(why_failed(result), HasSubstr("could not be started: No such file"));
}

TEST(Process, ShowsItsOutputAsItComesAndKeepsTheEndOfMuch) {
    std::size_t seen = 0;
    const ProcessResult result =
        shell("yes | head -c 9000000; echo end",
              {10, "", [&](const std::string& text) { seen = std::max(seen, text.size()); }});
    EXPECT_THAT(result.output, EndsWith("y\nend\n"));
    EXPECT_GE(seen, std::size_t(4) << 20);
    EXPECT_GE(result.output.size(), std::size_t(4) << 20);
    EXPECT_LE(result.output.size(), std::size_t(8) << 20);
}

} // namespace
} // namespace raylab
