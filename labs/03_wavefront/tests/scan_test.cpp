// Tasks 3.2 and 3.7: every scan against the definition, at lengths around every size a scan is
// built of.
#include "common/device/device_array.h"
#include "common/device/launch.h"
#include "common/task/facts.h"
#include "labs/03_wavefront/scan.h"

#include <algorithm>
#include <numeric>

namespace raylab::lab03 {

namespace {

using namespace task;

constexpr const char* names[] = {"serial", "naive", "efficient", "warp", "library", "lookback"};

// Numbers that look random, and sums that wrap.
std::vector<std::uint32_t> numbers(std::int64_t n) {
    std::vector<std::uint32_t> values(n);
    std::uint32_t state = 12345;
    for (std::uint32_t& value : values) value = (state = state * 1664525u + 1013904223u) >> 3;
    return values;
}

constexpr std::uint32_t unwritten = 0xdeadbeef;
constexpr int behind = 2048; // so many numbers behind the end are watched

// Fails the test if the scan writes where it must not.
std::vector<std::uint32_t> scanned(ScanKind kind, const std::vector<std::uint32_t>& values) {
    const std::int64_t n = static_cast<std::int64_t>(values.size());
    const DeviceArray<std::uint32_t> in(values);
    DeviceArray<std::uint32_t> out(std::vector<std::uint32_t>(values.size() + behind, unwritten)),
        workspace(scan_workspace(kind, n) + behind);
    scan_function(kind)(in.data(), out.data(), n, workspace.data());
    expect(in.to_host() == values, "the scan changed its input");
    std::vector<std::uint32_t> result = out.to_host();
    expect(std::count(result.begin() + n, result.end(), unwritten) == behind,
           fmt::format("scan_{} of {} numbers writes behind the end of `out`; the likely cause: "
                       "threads from n on must write nothing",
                       names[static_cast<int>(kind)], n));
    result.resize(values.size());
    return result;
}

// Of a scan whose first wrong sum is out[i].
const char* likely_cause(ScanKind kind, std::int64_t i) {
    if (kind == ScanKind::naive)
        return "a round must read `from` only, which no thread writes, and write each element of "
               "`to`, in either case";
    if (kind == ScanKind::warp)
        return "in each of the rounds 1, 2, 4, 8, 16 all lanes shuffle, and a lane adds what it "
               "got if its place in its warp, threadIdx.x % 32, is `distance` or more";
    if (kind == ScanKind::lookback)
        return "look_back() must add the sums of all tiles before this one, each once: wait for "
               "words that say nothing yet, add up to the nearest complete one, and go on with the "
               "next 32 tiles if there is none";
    if (kind != ScanKind::efficient) return "this scan is given";
    return i == 0     ? "the scan is exclusive: nothing comes before the first number, so one "
                        "thread clears the root of the tree, with a barrier before and behind"
           : i < 1024 ? "a barrier is missing: one stands before each level, up and down, before "
                        "the root and before the end; or a level, or what a node hands to its left"
                      : "the sums of the tiles before: each block writes its root to "
                        "sums[blockIdx.x], before it is cleared, also the last one, some of whose "
                        "threads have no numbers and must not return early";
}

bool expect_right(ScanKind kind, std::int64_t n) {
    const std::vector<std::uint32_t> values = numbers(n);
    std::vector<std::uint32_t> expected(values.size());
    std::exclusive_scan(values.begin(), values.end(), expected.begin(), std::uint32_t{0});
    const std::vector<std::uint32_t> result = scanned(kind, values);
    if (testing::Test::HasFailure()) return false;
    const auto [wrong, right] = std::mismatch(result.begin(), result.end(), expected.begin());
    if (wrong == result.end()) return true;
    const auto i = wrong - result.begin();
    return expect_equal(
        fmt::format("scan_{} of {} numbers: out[{}]", names[static_cast<int>(kind)], n, i), *wrong,
        *right, likely_cause(kind, i));
}

void expect_right_at_any_length(ScanKind kind) {
    for (const std::int64_t n :
         {0, 1, 2, 3, 31, 32, 33, 127, 128, 129, 1023, 1024, 1025, 5000, 1 << 17})
        if (!expect_right(kind, n)) return;
}

// Three levels of tiles. What fails at 1025 need not be tried with a million.
void expect_right_around_a_million(ScanKind kind) {
    if (!expect_right(kind, 1025)) return;
    for (const std::int64_t n : {(1 << 20) - 1, 1 << 20, (1 << 20) + 1})
        if (!expect_right(kind, n)) return;
}

void expect_right_at_ten_million(ScanKind kind) {
    if (expect_right(kind, 1025)) expect_right(kind, 10'000'000);
}

// What compaction scans: zeros and ones.
void expect_right_counts(ScanKind kind) {
    const std::vector<std::uint32_t> none(1500, 0), all(1500, 1);
    std::vector<std::uint32_t> index(1500);
    std::iota(index.begin(), index.end(), 0u);
    expect(scanned(kind, none) == none, "the scan of zeros is not zero");
    expect(scanned(kind, all) == index, "the scan of ones is not 0, 1, 2, ...");
}

class Task3_2 : public testing::TestWithParam<ScanKind> {};

TEST_P(Task3_2, IsTheSumOfAllBeforeAtAnyLength) { expect_right_at_any_length(GetParam()); }
TEST_P(Task3_2, HoldsAroundAMillion) { expect_right_around_a_million(GetParam()); }
TEST_P(Task3_2, HoldsAtTenMillion) { expect_right_at_ten_million(GetParam()); }
TEST_P(Task3_2, CountsFlags) { expect_right_counts(GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, Task3_2,
                         testing::Values(ScanKind::serial, ScanKind::naive, ScanKind::efficient,
                                         ScanKind::warp, ScanKind::library),
                         [](const auto& info) { return names[static_cast<int>(info.param)]; });

constexpr ScanKind lookback = ScanKind::lookback;

TEST(Task3_7, IsTheSumOfAllBeforeAtAnyLength) { expect_right_at_any_length(lookback); }
TEST(Task3_7, HoldsAroundAMillion) { expect_right_around_a_million(lookback); }
TEST(Task3_7, HoldsAtTenMillion) { expect_right_at_ten_million(lookback); }
TEST(Task3_7, CountsFlags) { expect_right_counts(lookback); }

// Whichever blocks start first, and however many run at once. If this does not end, a tile waits
// for one that no block has begun: a block's number must not be its tile's.
TEST(Task3_7, EndsInWhateverOrderBlocksStart) {
    for (const int threads : {1, 2, 5})
        for (const MachineSettings& machine :
             {MachineSettings{.threads = threads, .order = ThreadOrder::reverse},
              MachineSettings{.threads = threads, .order = ThreadOrder::random, .order_seed = 1},
              MachineSettings{.threads = threads, .order = ThreadOrder::random, .order_seed = 2}}) {
            configure_machine(machine);
            for (const std::int64_t n : {1025, 50'000})
                if (!expect_right(lookback, n)) return;
        }
}

} // namespace

} // namespace raylab::lab03
