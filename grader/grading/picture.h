// A picture that a submission draws in the sandbox, judged by the trusted judge. The submission's
// process never sees a reference: the solution draws it elsewhere, with seeds that are chosen now.
#pragma once

#include "common/image/image.h"
#include "grader/judge/independent.h"
#include "grader/results/marks.h"
#include "grader/sandbox/sandbox.h"

#include <functional>
#include <optional>

namespace raylab::grading {

// One render, as it came out.
struct Drawn {
    Image image;
    std::string ledger;                      // JSON
    MarkVerdict trouble = MarkVerdict::pass; // else why there is no image,
    std::string sentence;                    // in words
    double seconds = 0;
};

using Draw = std::function<Drawn(std::uint32_t seed, int spp)>;

// Draws a scene with a program of the submission, fresh each time.
struct SubmittedDrawing {
    std::filesystem::path program;
    std::string lab;
    std::filesystem::path scene;
    std::vector<std::filesystem::path> assets; // folders of the files that it names
    std::vector<std::string> options;
    const sandbox::Isolation* isolation;
    Drawn operator()(std::uint32_t seed, int spp) const;
};

// The same with the solution's program, outside the sandbox. Throws std::runtime_error.
struct SolutionDrawing {
    std::filesystem::path program;
    std::string lab;
    std::filesystem::path scene;
    Drawn operator()(std::uint32_t seed, int spp) const;
};

struct PictureResult {
    MarkVerdict verdict = MarkVerdict::pass;
    std::string sentence;
    bool same_paths = false;       // it drew the solution's paths one by one
    bool same_counts = true;       // and its ledger counts what the solution's does
    std::optional<Verdict> judged; // with figures
    std::optional<Image> image, reference;
    double seconds = 0; // in the sandbox
};

// Two renders with the same random numbers as the solution's; if they differ, the two stages with
// independent ones, against a reference of the solution (docs/architecture.md, Judging).
PictureResult judge_picture(const Draw& submission, const Draw& solution);

} // namespace raylab::grading
