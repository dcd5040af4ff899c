// What raylab says where it was built without Embree.
#include "grader/bench/rays/ray_contestant.h"

#include <gmock/gmock.h>

namespace raylab::bench {
namespace {

TEST(NoEmbree, SaysWhatToInstall) {
    for (const bool robust : {false, true}) try {
            embree(robust);
            FAIL();
        } catch (const ContestantError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("install libembree-dev"));
        }
}

} // namespace
} // namespace raylab::bench
