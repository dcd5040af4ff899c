// Task 2.6: the ledger's counts, held against the records of all paths, added up one by one.
#include "common/task/facts.h"
#include "labs/02_iterative/tests/atomic_counts.h"
#include "labs/02_iterative/tests/small_renders.h"

#include <algorithm>

namespace raylab::lab02 {

namespace {

using namespace task;

constexpr int lanes_of_warp = 32;

// A closed box in grey with a lamp: paths of all lengths. 97 x 41 pixels are 125 warps, of which
// the last has 9 paths; they are counted by several blocks.
constexpr int width = 97, height = 41;

Scene box() {
    return small_scene(
        {.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.3, 0.3, 0.3]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         .shapes = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 6, "material": "grey"},
            {"kind": "quad", "material": "lamp",
             "vertices": [[-2, 3, -2], [2, 3, -2], [2, 3, 2], [-2, 3, 2]]})",
         .render = R"("max_depth": 9, "spp": 1, "roulette": true)",
         .width = width,
         .height = height});
}

struct Counts {
    std::vector<BounceCounts> bounces = std::vector<BounceCounts>(9);
    std::uint64_t shadow_rays = 0;

    // A path of n rays was alive in bounces 0 to n - 1; a warp is busy as long as one of its paths.
    void add(const std::vector<PathRecord>& records) {
        for (std::size_t first = 0; first < records.size(); first += lanes_of_warp) {
            int longest = 0;
            for (std::size_t i = first; i < std::min(first + lanes_of_warp, records.size()); ++i) {
                for (int b = 0; b < records[i].length; ++b) ++bounces[b].rays;
                ++bounces[records[i].length - 1].ended[static_cast<int>(records[i].end)];
                shadow_rays += records[i].shadow_rays;
                longest = std::max<int>(longest, records[i].length);
            }
            for (int b = 0; b < longest; ++b) bounces[b].lanes += lanes_of_warp;
        }
    }
};

// Where `counted` paths of `drawn` are in the ledger.
std::string total_cause(std::uint64_t counted, std::uint64_t drawn, int iterations) {
    const std::uint64_t last_warp = width * height % lanes_of_warp;
    if (counted == drawn - iterations * last_warp)
        return "a last warp that is not full is counted, too";
    if (counted == drawn + iterations * (lanes_of_warp - last_warp))
        return "records behind the last are read: the last warp has fewer than 32 paths";
    return "each thread counts a warp of its own, number blockIdx.x * blockDim.x + threadIdx.x";
}

TEST(Task2_6, EveryPathIsCountedOnce) {
    const Scene scene = box();
    constexpr int iterations = 3;
    const std::uint64_t drawn = std::uint64_t{iterations} * width * height;
    for (const int block : {32, 128}) {
        const std::unique_ptr<Renderer> renderer = make_renderer(scene, {.block_size = block});
        const std::string error = error_of([&] {
            for (int i = 0; i < iterations; ++i) renderer->add_iteration();
        });
        if (!expect(error.empty(),
                    fmt::format("{} paths in blocks of {} are not counted to the end; the likely "
                                "cause: records behind the last are read: the last warp has fewer "
                                "than 32 paths. {}",
                                width * height, block, error)))
            return;
        const Ledger ledger = renderer->ledger();
        if (!expect_equal(
                fmt::format("paths counted in {} iterations, in blocks of {}", iterations, block),
                ledger.bounces[0].rays, drawn,
                total_cause(ledger.bounces[0].rays, drawn, iterations)))
            return;
    }
}

TEST(Task2_6, NoCountIsLost) {
    expect_equal("counts of 100 x 1000 paths that are changed other than by atomic operations",
                 changed_without_atomics(100 * 1000), 0,
                 "threads of several blocks add to the same count at the same time: atomicAdd(), "
                 "not +=");
}

TEST(Task2_6, TheLedgerAgreesWithThePaths) {
    const Scene scene = box();
    for (const int block : {64, 128}) {
        const std::unique_ptr<Renderer> renderer = make_renderer(scene, {.block_size = block});
        Counts expected;
        for (int iteration = 0; iteration < 3; ++iteration) {
            renderer->add_iteration();
            const std::vector<PathRecord> records = renderer->records();
            if (!expect(std::all_of(records.begin(), records.end(),
                                    [](const PathRecord& r) { return r.length > 0; }),
                        "the kernel left no records to count"))
                return;
            expected.add(records);
        }
        const Ledger ledger = renderer->ledger();
        expect_equal("shadow rays of 3 iterations", ledger.shadow_rays, expected.shadow_rays,
                     "a warp's shadow rays are added up, to any one of the shards");
        const auto in = [&](std::size_t b) {
            return fmt::format(" in bounce {}, in blocks of {}", b, block);
        };
        for (std::size_t b = 0; b < expected.bounces.size(); ++b)
            if (!expect_equal("rays" + in(b), ledger.bounces[b].rays, expected.bounces[b].rays,
                              "a path of length n ended in bounce n - 1") ||
                !expect_equal("lanes held" + in(b), ledger.bounces[b].lanes,
                              expected.bounces[b].lanes,
                              "a warp is busy until its longest path ends"))
                return;
        for (std::size_t b = 0; b < expected.bounces.size(); ++b)
            for (const auto& [what, end] : {std::pair{"roulette", PathEnd::roulette},
                                            {"absorption", PathEnd::absorbed},
                                            {"depth", PathEnd::depth}})
                if (!expect_equal(fmt::format("paths ended by {}{}", what, in(b)),
                                  ledger.bounces[b].ended[static_cast<int>(end)],
                                  expected.bounces[b].ended[static_cast<int>(end)],
                                  "ended[] is counted by the record's cause"))
                    return;
    }
}

} // namespace

} // namespace raylab::lab02
