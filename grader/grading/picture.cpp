#include "grader/grading/picture.h"

#include "common/cli/files.h"
#include "common/cli/process.h"
#include "common/image/formats.h"
#include "common/image/image_file.h"
#include "common/image/mean.h"
#include "grader/grading/secret.h"
#include "grader/judge/same_paths.h"
#include "grader/sandbox/work_folder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr double draw_limit_seconds = 60; // pictures of 96 x 96 take a second
constexpr std::uint64_t image_bytes = 1 << 20, ledger_bytes = 1 << 20;
constexpr int paired_renders = 2; // with the solution's random numbers

constexpr double most_shared_noise = 3; // 1 without a blur, 9 with one over 3 x 3 pixels
constexpr int reference_replicates = 32, reference_spp = 64;

std::vector<std::string> command_of(const fs::path& program, const std::string& lab,
                                    const fs::path& scene, const fs::path& out, std::uint32_t seed,
                                    int spp, const std::vector<std::string>& options) {
    std::vector<std::string> command = {program,
                                        lab,
                                        scene,
                                        out / "image.pfm",
                                        out / "ledger.json",
                                        "--seed",
                                        std::to_string(seed),
                                        "--spp",
                                        std::to_string(spp)};
    command.insert(command.end(), options.begin(), options.end());
    return command;
}

MarkVerdict verdict_of(sandbox::End end) {
    switch (end) {
    case sandbox::End::exited:
        return MarkVerdict::no_output;
    case sandbox::End::crashed:
        return MarkVerdict::crash;
    case sandbox::End::time_limit:
        return MarkVerdict::time_limit;
    case sandbox::End::output_limit:
        return MarkVerdict::output_limit;
    case sandbox::End::memory_limit:
    case sandbox::End::process_limit:
        return MarkVerdict::memory_limit;
    case sandbox::End::not_started:
        return MarkVerdict::internal;
    }
    return MarkVerdict::internal;
}

// ": what it said last".
std::string last_line(std::string output) {
    while (output.ends_with('\n')) output.pop_back();
    const std::string line = output.substr(output.rfind('\n') + 1);
    return line.empty() ? "" : ": " + line.substr(0, 300);
}

// The counts that a ledger's rays and lanes are made of; nothing that depends on the machine.
nlohmann::json counts_of(const std::string& ledger) {
    const auto json = nlohmann::json::parse(ledger, nullptr, false);
    if (!json.is_object()) return {};
    nlohmann::json counts;
    for (const char* key : {"bounces", "shadow_rays", "samples"})
        if (json.contains(key)) counts[key] = json[key];
    return counts;
}

void fail(PictureResult& result, MarkVerdict verdict, const std::string& sentence) {
    result.verdict = verdict;
    result.sentence = sentence;
}

// Not sound: which name it has.
MarkVerdict name_of(const Soundness& soundness, const Image& image, const Image& reference) {
    if (image.width != reference.width || image.height != reference.height)
        return MarkVerdict::wrong_size;
    if (soundness.not_finite > 0) return MarkVerdict::non_finite;
    return MarkVerdict::wrong_image;
}

Image reference_of(const Draw& solution) {
    ImageMean mean;
    const std::uint32_t seed = random_number();
    for (int r = 0; r < reference_replicates; ++r)
        mean.add(solution(seed + static_cast<std::uint32_t>(r), reference_spp).image);
    return mean.mean();
}

// A render that gave no image ends the judgement.
struct NoImage {
    Drawn drawn;
};

void judge_independently(PictureResult& result, const Draw& submission, const Draw& solution) {
    const Image reference = reference_of(solution);
    IndependentOptions options;
    options.first_seed = random_number();
    const IndependentResult judged = judge_independent(
        [&](std::uint32_t seed, int spp) {
            Drawn drawn = submission(seed, spp);
            result.seconds += drawn.seconds;
            if (drawn.trouble != MarkVerdict::pass) throw NoImage{drawn};
            drawn.image.provenance.spp = spp;
            return std::move(drawn.image);
        },
        reference, options);
    result.judged = judged.verdict;
    result.image = judged.mean;
    result.reference = reference;
    result.sentence = judged.verdict.sentence;
    // A blur keeps the mean of a tile. But no lab mixes pixels, so their noise is independent.
    if (judged.verdict.passed && judged.honesty.tile_ratio > most_shared_noise)
        fail(result, MarkVerdict::suspicious,
             fmt::format(
                 "Neighbouring pixels share their noise: the means of tiles vary {:.1f} times as "
                 "much as those of independent pixels. The picture was blurred or denoised.",
                 judged.honesty.tile_ratio));
    if (judged.verdict.passed) return;
    if (!judged.soundness.verdict.passed)
        fail(result,
             judged.soundness.not_finite > 0 ? MarkVerdict::non_finite : MarkVerdict::wrong_image,
             judged.soundness.verdict.sentence);
    else
        result.verdict =
            judged.honesty.seed_ignored ? MarkVerdict::suspicious : MarkVerdict::wrong_image;
}

} // namespace

Drawn SubmittedDrawing::operator()(std::uint32_t seed, int spp) const {
    const sandbox::WorkFolder out(*isolation, 8 << 20, 32);
    sandbox::SandboxOptions run;
    run.readable = {program, scene};
    for (const fs::path& folder : assets) run.readable.emplace_back(folder);
    run.writable = {out.path()};
    run.limits = {.wall_seconds = 3 * draw_limit_seconds,
                  .cpu_seconds = draw_limit_seconds,
                  .memory = 2ull << 30,
                  .file_size = 4 << 20};
    const sandbox::Outcome outcome = sandbox::run(
        command_of(program, lab, scene, out.path(), seed, spp, options), run, *isolation);
    Drawn drawn;
    drawn.seconds = outcome.seconds;
    if (outcome.end == sandbox::End::not_started)
        throw std::runtime_error("a render could not be started in the sandbox: " +
                                 outcome.trouble);
    if (!outcome.succeeded()) {
        drawn.trouble = verdict_of(outcome.end);
        drawn.sentence = fmt::format("no picture: {}{}", sandbox::why(outcome, run.limits),
                                     last_line(outcome.output));
        return drawn;
    }
    const sandbox::OutputFile file = sandbox::read_output(out.path(), "image.pfm", image_bytes);
    if (!file.trouble.empty()) {
        drawn.trouble = MarkVerdict::no_output;
        drawn.sentence = "no picture: " + file.trouble;
        return drawn;
    }
    try {
        drawn.image = formats::decode_pfm(file.bytes);
    } catch (const std::exception& error) {
        drawn.trouble = MarkVerdict::no_output;
        drawn.sentence = fmt::format("the picture cannot be read: {}", error.what());
    }
    drawn.ledger = sandbox::read_output(out.path(), "ledger.json", ledger_bytes).bytes;
    return drawn;
}

Drawn SolutionDrawing::operator()(std::uint32_t seed, int spp) const {
    sandbox::Isolation none; // a folder of one's own, without another user
    const sandbox::WorkFolder out(none, 0, 0);
    const ProcessResult result = run_process(
        command_of(program, lab, scene, out.path(), seed, spp, {}), {10 * draw_limit_seconds});
    if (!result.succeeded())
        throw std::runtime_error(
            fmt::format("the solution did not draw the reference, {}", why_failed(result)));
    Drawn drawn;
    drawn.image = read_image((out.path() / "image.pfm").string());
    drawn.image.provenance.spp = spp;
    drawn.ledger = read_file((out.path() / "ledger.json").string());
    return drawn;
}

PictureResult judge_picture(const Draw& submission, const Draw& solution) try {
    PictureResult result;
    result.same_paths = true;
    for (int pair = 0; pair < paired_renders; ++pair) {
        const std::uint32_t seed = random_number();
        const int spp =
            4 + static_cast<int>(random_number() % 24); // nobody knows when it is the last

        Drawn drawn = submission(seed, spp);
        result.seconds += drawn.seconds;
        if (drawn.trouble != MarkVerdict::pass) throw NoImage{drawn};
        Drawn expected = solution(seed, spp);
        drawn.image.provenance.spp = spp;
        const Soundness sound =
            check_soundness(drawn.image, expected.image.width, expected.image.height);
        result.image = drawn.image;
        if (!sound.verdict.passed) {
            fail(result, name_of(sound, drawn.image, expected.image), sound.verdict.sentence);
            return result;
        }
        const SamePathsResult paired = judge_same_paths(drawn.image, expected.image);
        result.same_paths = result.same_paths && paired.verdict.passed;
        result.same_counts =
            result.same_counts && counts_of(drawn.ledger) == counts_of(expected.ledger);
        result.judged = paired.verdict;
        result.judged->measured = {
            {measure(drawn.image, expected.image), z_map(drawn.image, expected.image)}};
        result.reference = expected.image;
        result.sentence = paired.verdict.sentence;
        if (!result.same_paths) break;
    }
    if (!result.same_paths) judge_independently(result, submission, solution);
    return result;
} catch (const NoImage& none) {
    PictureResult result;
    fail(result, none.drawn.trouble, none.drawn.sentence);
    return result;
}

} // namespace raylab::grading
