// Every scan against the definition, at lengths around every size that a scan is built of.
#include "common/device/device_array.h"
#include "labs/03_wavefront/scan.h"

#include <gtest/gtest.h>

#include <numeric>

namespace raylab::lab03 {

namespace {

class Scan : public testing::TestWithParam<ScanKind> {};

// Numbers that look random, and sums that wrap.
std::vector<std::uint32_t> numbers(std::int64_t n) {
    std::vector<std::uint32_t> values(n);
    std::uint32_t state = 12345;
    for (std::uint32_t& value : values) value = (state = state * 1664525u + 1013904223u) >> 3;
    return values;
}

std::vector<std::uint32_t> scanned(ScanKind kind, const std::vector<std::uint32_t>& values) {
    const std::int64_t n = static_cast<std::int64_t>(values.size());
    const DeviceArray<std::uint32_t> in(values);
    DeviceArray<std::uint32_t> out(values.size()), workspace(scan_workspace(kind, n));
    scan_function(kind)(in.data(), out.data(), n, workspace.data());
    EXPECT_EQ(in.to_host(), values) << "the scan changed its input";
    return out.to_host();
}

void expect_right(ScanKind kind, std::int64_t n) {
    const std::vector<std::uint32_t> values = numbers(n);
    std::vector<std::uint32_t> expected(values.size());
    std::exclusive_scan(values.begin(), values.end(), expected.begin(), std::uint32_t{0});
    const std::vector<std::uint32_t> result = scanned(kind, values);
    const auto [wrong, right] = std::mismatch(result.begin(), result.end(), expected.begin());
    ASSERT_TRUE(wrong == result.end())
        << "of " << n << " numbers, out[" << wrong - result.begin() << "] should be " << *right
        << " but is " << *wrong;
}

TEST_P(Scan, IsTheSumOfAllBeforeAtAnyLength) {
    for (const std::int64_t n :
         {0, 1, 2, 3, 31, 32, 33, 127, 128, 129, 1023, 1024, 1025, 5000, 1 << 17})
        expect_right(GetParam(), n);
}

// Two and three levels of tiles.
TEST_P(Scan, HoldsAroundAMillionAndAtTenMillion) {
    for (const std::int64_t n : {(1 << 20) - 1, 1 << 20, (1 << 20) + 1}) {
        expect_right(GetParam(), n);
        if (std::getenv("RAYLAB_LONG") == nullptr) break;
    }
    if (std::getenv("RAYLAB_LONG") != nullptr) expect_right(GetParam(), 10'000'000);
}

// What compaction scans: zeros and ones.
TEST_P(Scan, CountsFlags) {
    const std::vector<std::uint32_t> none(1500, 0), all(1500, 1);
    EXPECT_EQ(scanned(GetParam(), none), none);
    std::vector<std::uint32_t> index(1500);
    std::iota(index.begin(), index.end(), 0u);
    EXPECT_EQ(scanned(GetParam(), all), index);
}

INSTANTIATE_TEST_SUITE_P(All, Scan,
                         testing::Values(ScanKind::serial, ScanKind::naive, ScanKind::efficient,
                                         ScanKind::warp, ScanKind::library));

// No grid here has 2^33 threads, but its indices are right.
static_assert(grid_index(0x7fffffffu, 1024, 1023) == (std::int64_t{1} << 41) - 1);
static_assert(grid_index(1u << 21, 1024, 7) == (std::int64_t{1} << 31) + 7);

} // namespace

} // namespace raylab::lab03
