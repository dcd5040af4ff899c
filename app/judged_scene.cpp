#include "app/judged_scene.h"

#include "common/image/image_file.h"
#include "common/load/load.h"
#include "common/render/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace raylab::app {

JudgedScene judge_scene(const Lab& lab, const Scene& scene, const Image& reference,
                        const MachineSettings& machine, std::uint32_t first_seed) {
    JudgedScene judged;
    judged.lab = lab.folder;
    judged.scene = scene.name;
    judged.title = scene.title;
    judged.reason = scene.reason;

    IndependentOptions options;
    options.first_seed = first_seed;
    options.spp = std::max(1, scene.render.spp / options.replicates);
    std::vector<Image> first_stage;
    const std::unique_ptr<Renderer> renderer = lab.make(scene, machine);
    const auto replicate = [&](std::uint32_t seed, int spp) {
        Render drawn = render(*renderer, scene, scene.camera, seed, spp);
        judged.seconds += drawn.ledger.seconds;
        if (seed == first_seed) judged.ledger = std::move(drawn.ledger);
        if (first_stage.size() < static_cast<std::size_t>(options.replicates))
            first_stage.push_back(drawn.image);
        return std::move(drawn.image);
    };
    judged.judgement = judge_independent(replicate, reference, options);
    judged.image = judged.judgement.mean;
    judged.first = first_stage.front();
    judged.passed = judged.judgement.verdict.passed;
    for (const Expectation& expectation : scene.expect) {
        judged.expectations.push_back(check_expectation(expectation, first_stage));
        judged.passed = judged.passed && judged.expectations.back().met;
    }
    return judged;
}

void judge_against(JudgedScene& judged, const JudgedScene& other) {
    judged.same_paths = judge_same_paths(judged.first, other.first);
    Verdict& verdict = judged.same_paths->verdict;
    verdict.sentence =
        fmt::format("Against {}, with the same random numbers: {}", other.lab, verdict.sentence);
    judged.passed = judged.passed && verdict.passed;
}

Image load_reference(const Scene& scene) {
    const std::filesystem::path path =
        find_scene("cornell").parent_path() / "references" / (scene.name + ".exr");
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        throw UsageError(
            fmt::format("there is no reference '{}': make one with `raylab reference {}`",
                        path.string(), scene.name));
    Image reference = read_image(path.string());
    if (reference.provenance.scene_hash != scene.hash)
        throw UsageError(fmt::format(
            "'{}' was made of another version of the scene (hash {}, the scene's is {}): make it "
            "anew with `raylab reference {}`",
            path.string(), reference.provenance.scene_hash, scene.hash, scene.name));
    return reference;
}

} // namespace raylab::app
