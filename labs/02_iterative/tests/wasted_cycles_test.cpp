// Task 2.6: the ledger's counts, held against the records of all paths, added up one by one.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/02_iterative/renderer.h"

#include <algorithm>

namespace raylab::lab02 {

namespace {

using namespace task;

constexpr int lanes_of_warp = 32;

// A closed box in grey with a lamp: paths of all lengths. 185 pixels: the last warp has 25.
Scene box() {
    return small_scene(
        {.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.3, 0.3, 0.3]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         .shapes = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 6, "material": "grey"},
            {"kind": "quad", "material": "lamp",
             "vertices": [[-2, 3, -2], [2, 3, -2], [2, 3, 2], [-2, 3, 2]]})",
         .render = R"("max_depth": 9, "spp": 1, "roulette": true)",
         .width = 37,
         .height = 5});
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
        for (std::size_t b = 0; b < expected.bounces.size(); ++b) {
            const BounceCounts& counts = ledger.bounces[b];
            const std::string in = fmt::format(" in bounce {}, in blocks of {}", b, block);
            if (!expect_equal("rays" + in, counts.rays, expected.bounces[b].rays,
                              "a path of length n ended in bounce n - 1; the last warp may have "
                              "fewer than 32 paths") ||
                !expect_equal("lanes held" + in, counts.lanes, expected.bounces[b].lanes,
                              "a warp is busy until its longest path ends") ||
                !expect_equal("paths ended by roulette" + in,
                              counts.ended[static_cast<int>(PathEnd::roulette)],
                              expected.bounces[b].ended[static_cast<int>(PathEnd::roulette)],
                              "ended[] is counted by the record's cause") ||
                !expect_equal("paths ended by absorption" + in,
                              counts.ended[static_cast<int>(PathEnd::absorbed)],
                              expected.bounces[b].ended[static_cast<int>(PathEnd::absorbed)],
                              "ended[] is counted by the record's cause"))
                return;
        }
    }
}

} // namespace

} // namespace raylab::lab02
