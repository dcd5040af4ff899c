#include "grader/sandbox/capture.h"

#include <gtest/gtest.h>

#include <string>

namespace raylab::sandbox {
namespace {

// Of more than 64 KiB the middle is cut, and the text says so, in whatever pieces the bytes came.
TEST(Capture, SaysThatItCut) {
    for (const std::size_t block : {100u, 1000u, 40'000u, 65'536u, 200'000u}) {
        Capture capture;
        while (capture.total() < 200'000) {
            capture.add(std::string(block, 'x'));
            const std::string text = capture.text();
            const bool cut = text.find("[... cut here ...]") != text.npos;
            ASSERT_EQ(cut, capture.total() > 64 << 10) << block << ", " << capture.total();
            ASSERT_LE(text.size(), 70'000u);
            if (!cut) {
                ASSERT_EQ(text.size(), capture.total());
            }
        }
    }
}

} // namespace
} // namespace raylab::sandbox
