// From instructions to lines, through functions of the CPU machine's headers that were inlined.
#include "common/simt/engine/where_is.h"

#include "common/simt/atomics.h"

#include <gtest/gtest.h>

namespace raylab::simt {

namespace {

const void* caller = nullptr;

[[gnu::noinline]] void remember_caller() {
    caller = static_cast<const char*>(__builtin_return_address(0)) - 1;
}

[[gnu::noinline]] float add_one(float x) {
    caller = static_cast<const char*>(__builtin_return_address(0)) - 1;
    return x + 1;
}

TEST(WhereIs, ALineOfThisFile) {
    remember_caller();
    const int line = __LINE__ - 1;
    const auto place = source_place(caller);
    if (!place && function_name(caller).empty()) GTEST_SKIP() << "there is no libdw";
    ASSERT_TRUE(place);
    EXPECT_TRUE(place->file.ends_with("common/simt/tests/where_is_test.cpp")) << place->file;
    EXPECT_EQ(place->line, line);
    EXPECT_GT(place->column, 0);
    EXPECT_NE(function_name(caller).find("ALineOfThisFile"), std::string::npos);
}

TEST(WhereIs, TheCallOfWhatWasInlined) {
    float x = 1;
    atomic_update(&x, add_one);
    const int line = __LINE__ - 1;
    const auto place = source_place(caller);
    if (!place && function_name(caller).empty()) GTEST_SKIP() << "there is no libdw";
    ASSERT_TRUE(place);
    EXPECT_EQ(place->line, line) << place->file;
}

TEST(WhereIs, NothingForWhatIsNoCode) {
    const int data = 0;
    EXPECT_FALSE(source_place(&data));
    EXPECT_FALSE(source_place(nullptr));
    EXPECT_EQ(function_name(nullptr), "");
}

} // namespace

} // namespace raylab::simt
