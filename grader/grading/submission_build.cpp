#include "grader/grading/submission_build.h"

#include "common/cli/files.h"
#include "common/cli/process.h"
#include "grader/course/compiler_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t work_bytes = 2ull << 30;
constexpr int work_files = 20000;

// With times, by which Ninja knows what is built already.
void copy_tree(const fs::path& from, const fs::path& to) {
    const ProcessResult result = run_process({"cp", "-a", "--", from.string(), to.string()}, {300});
    if (!result.succeeded())
        throw std::runtime_error(
            fmt::format("'{}' could not be copied: {}", from.string(), why_failed(result)));
}

bool same_bytes(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::file_size(a, error) != fs::file_size(b, error) || error) return false;
    std::ifstream one(a, std::ios::binary), two(b, std::ios::binary);
    return std::equal(std::istreambuf_iterator<char>(one), std::istreambuf_iterator<char>(),
                      std::istreambuf_iterator<char>(two));
}

} // namespace

SubmissionBuild::SubmissionBuild(const BaseBuild& base, const fs::path& folder,
                                 const std::vector<std::string>& files,
                                 const sandbox::Isolation& isolation)
    : base_(base), isolation_(isolation), work_(isolation, work_bytes, work_files) {
    const fs::path lab = sheet().path();
    fs::create_directories(lab.parent_path());
    copy_tree(base.lab(), lab);
    copy_tree(base.build(), work_.path() / "build");
    for (const std::string& file : files) {
        const std::string text = read_file((folder / file).string());
        if (read_file((lab / file).string()) == text) continue;
        std::ofstream(lab / file, std::ios::binary | std::ios::trunc) << text;
    }
    // Without mounts the submission is built where the base was, which is put back afterwards.
    if (!isolation_.maps) {
        fs::rename(base_.build(), base_.folder / "build.base");
        fs::rename(base_.lab(), base_.folder / "lab.base");
        copy_tree(work_.path() / "build", base_.build());
        copy_tree(lab, base_.lab());
        sandbox::give_to_sandbox(base_.build(), isolation_);
        fs::create_directory(temporary());
        sandbox::give_to_sandbox(temporary(), isolation_);
    } else {
        sandbox::give_to_sandbox(work_.path() / "build", isolation_);
    }
}

SubmissionBuild::~SubmissionBuild() {
    if (isolation_.maps) return;
    std::error_code ignored;
    fs::remove_all(base_.build(), ignored);
    fs::rename(base_.folder / "build.base", base_.build(), ignored);
    fs::remove_all(base_.lab(), ignored);
    fs::rename(base_.folder / "lab.base", base_.lab(), ignored);
}

sandbox::Limits SubmissionBuild::limits() {
    return {.wall_seconds = 1800, // nothing of a submission runs: only a busy machine takes so long
            .cpu_seconds = 120,
            .memory = 3ull << 30,
            .file_size = 256ull << 20,
            .output = 4ull << 20,
            .private_files = 512ull << 20,
            .processes = 64};
}

const sandbox::Outcome& SubmissionBuild::build() {
    sandbox::SandboxOptions options;
    options.folder = base_.tree();
    options.environment = {{"CCACHE_DISABLE", "1"}};
    options.limits = limits();
    options.readable = {base_.tree()};
    if (isolation_.maps) {
        options.readable.emplace_back(sheet().path(), base_.lab());
        options.writable = {{work_.path() / "build", base_.build()}};
    } else {
        options.writable = {base_.build(), temporary()};
        options.environment["TMPDIR"] = temporary(); // the compiler's; /tmp is not the sandbox's
    }
    outcome_ = sandbox::run(
        {"/usr/bin/ninja", "-C", base_.build(), "-j2", base_.sheet.test_target, "raylab-draw"},
        options, isolation_);
    return outcome_;
}

fs::path SubmissionBuild::temporary() const { return work_.path() / "tmp"; }

std::string SubmissionBuild::compiler_errors() const {
    return raylab::compiler_errors(outcome_.output, base_.tree());
}

fs::path SubmissionBuild::build_folder() const {
    return isolation_.maps ? work_.path() / "build" : base_.build();
}

std::vector<std::string> SubmissionBuild::changed_objects() const {
    const fs::path base = isolation_.maps ? base_.build() : base_.folder / "build.base";
    std::vector<std::string> changed;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(build_folder()))
        if (entry.path().extension() == ".o" && entry.is_regular_file() && !entry.is_symlink()) {
            const fs::path name = entry.path().lexically_relative(build_folder());
            if (!same_bytes(entry.path(), base / name)) changed.push_back(name);
        }
    std::sort(changed.begin(), changed.end());
    return changed;
}

LabSheet SubmissionBuild::sheet() const {
    LabSheet sheet = base_.sheet;
    sheet.root = work_.path() / "root";
    return sheet;
}

} // namespace raylab::grading
