// Killed at any moment, and started again until it is done: the marks are those of an undisturbed
// run, and what the journal calls graded is not graded again.
#include "app/class/tests/class_in_folder.h"

#include <gmock/gmock.h>

#include <random>

namespace raylab {
namespace {

TEST(GradeClass, KilledAtAnyMomentIsResumed) {
    ClassInFolder undisturbed, killed;
    constexpr int students = 40, jobs = 3;
    for (int i = 0; i < students; ++i)
        for (ClassInFolder* all : {&undisturbed, &killed})
            all->student(fmt::format("s{:02}", i), i % 3 == 0   ? "right"
                                                   : i % 3 == 1 ? "half"
                                                                : "trouble");
    const std::string options = fmt::format("--jobs {}", jobs);
    ASSERT_EQ(undisturbed.run_all(options).code, 3);

    std::mt19937 random(1);
    // All graders together sleep for 1.3 s at the least, so that the first five are kills on any
    // machine; then there is more and more time, so that a slow one gets on.
    const auto moment = [&random](int kills) {
        return std::uniform_real_distribution<double>(0.02, kills < 5 ? 0.25 : 0.1 * kills)(random);
    };
    int kills = 0;
    for (;; ++kills) {
        ASSERT_LT(kills, 100) << "it does not get on";
        // SIGKILL to the program; the graders that it has started run on, as after a crash.
        const app::Outcome outcome = app::run_in_shell(
            fmt::format("timeout -s KILL {:.3f} env {}", moment(kills),
                        killed.command("'" + (killed / "subs").string() + "' " + options,
                                       "FAKE_SECONDS=0.1 ")));
        if (outcome.code == 3) break;
    }
    EXPECT_GE(kills, 5);
    EXPECT_EQ(killed.marks(), undisturbed.marks());
    // At each kill as many as there are jobs were on the way, and only they were begun again.
    int begun = 0;
    for (int i = 0; i < students; ++i) {
        EXPECT_GE(killed.logged(fmt::format("end s{:02}", i)), 1);
        begun += killed.logged(fmt::format("begin s{:02}", i));
    }
    EXPECT_LE(begun, students + jobs * kills);
    // Nothing is left of what was killed.
    std::size_t runs = 0;
    for ([[maybe_unused]] const auto& run :
         std::filesystem::directory_iterator(killed / "out/runs"))
        ++runs;
    EXPECT_EQ(runs, static_cast<std::size_t>(students - students / 3)); // trouble leaves no run
}

// Ctrl-C takes the graders with it and says nothing of those that were on the way.
TEST(GradeClass, InterruptedIsResumed) {
    ClassInFolder all;
    for (int i = 0; i < 4; ++i) all.student(fmt::format("s{}", i), "right");
    const app::Outcome outcome = app::run_in_shell(
        "timeout -s INT 0.5 env " +
        all.command("'" + (all / "subs").string() + "' --jobs 4", "FAKE_SECONDS=60 "));
    EXPECT_NE(outcome.code, 0);
    EXPECT_EQ(all.run("").code, 0);
    EXPECT_EQ(all.verdicts().size(), 4u);
    for (const auto& [id, verdict] : all.verdicts()) EXPECT_EQ(verdict, "100 PASS");
}

} // namespace
} // namespace raylab
