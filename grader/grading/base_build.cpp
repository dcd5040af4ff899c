#include "grader/grading/base_build.h"

#include "common/cli/files.h"
#include "common/cli/process.h"
#include "common/cli/sha256.h"
#include "grader/course/compiler_errors.h"
#include "grader/course/release.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr double build_limit_seconds = 3600; // a first build, on a slow machine

// Names, sizes and times of all that a students' tree is made of. The project's own tests are not
// in it; those of a lab's tasks are.
std::string stamp_of(const fs::path& root) {
    std::vector<std::string> lines;
    for (const char* part : {"app", "cmake", "common", "grader", "labs", "CMakeLists.txt",
                             "CMakePresets.json", "packages.txt"}) {
        const auto add = [&](const fs::path& file) {
            struct stat status {};
            if (stat(file.c_str(), &status) == 0)
                lines.push_back(fmt::format("{} {} {}.{}", file.string(), status.st_size,
                                            status.st_mtim.tv_sec, status.st_mtim.tv_nsec));
        };
        if (fs::is_regular_file(root / part)) add(root / part);
        if (!fs::is_directory(root / part)) continue;
        const bool with_tests = std::string_view(part) == "labs";
        fs::recursive_directory_iterator entry(root / part);
        for (; entry != fs::recursive_directory_iterator(); ++entry) {
            if (entry->is_regular_file()) add(entry->path());
            if (!with_tests && entry->path().filename() == "tests")
                entry.disable_recursion_pending();
        }
    }
    std::sort(lines.begin(), lines.end());
    Sha256 hash;
    for (const std::string& line : lines) hash.add(line + "\n");
    return hash.hex();
}

std::string read_or_empty(const fs::path& file) try {
    return read_file(file.string());
} catch (const FileError&) {
    return "";
}

void run_step(const std::vector<std::string>& command, const fs::path& tree) {
    const ProcessResult result = run_process(command, {build_limit_seconds, tree});
    if (!result.succeeded())
        throw std::runtime_error(fmt::format("the students' tree could not be built, {}:\n{}",
                                             why_failed(result),
                                             compiler_errors(result.output, tree)));
}

// As `prove` builds: -O1 and one variant of each kernel compile fast. ccache is for this build
// alone: what a submission compiles is kept nowhere.
void build(const BaseBuild& base) {
    const fs::path tree = base.tree();
    std::vector<std::string> configure = {(tree / "cmake/configure.sh").string(),
                                          base.build().string(),
                                          "-G",
                                          "Ninja",
                                          "-DCMAKE_BUILD_TYPE=None",
                                          "-DCMAKE_CXX_FLAGS=-O1",
                                          "-DRAYLAB_STRICT=OFF",
                                          "-DRAYLAB_TESTS=OFF",
                                          "-DRAYLAB_VARIANTS=one",
                                          "-DRAYLAB_WITNESS=ON"};
    if (run_process({"ccache", "--version"}, {10}).succeeded())
        configure.push_back("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache");
    run_step(configure, tree);
    run_step({"env", "CCACHE_NOHASHDIR=1", "CCACHE_BASEDIR=" + tree.string(), "cmake", "--build",
              base.build().string(), "--target", base.sheet.test_target, "raylab-draw"},
             tree);
}

// What a grader that was ended while it built a submission here has moved aside.
void put_back(const BaseBuild& base) {
    for (const auto& [aside, place] :
         {std::pair{base.folder / "build.base", base.build()},
          {base.folder / "lab.base", base.tree() / "labs" / base.sheet.folder}}) {
        if (!fs::exists(aside)) continue;
        fs::remove_all(place);
        fs::rename(aside, place);
    }
}

} // namespace

FolderLock::FolderLock(const fs::path& folder)
    : handle_(open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    if (handle_ < 0) throw std::system_error(errno, std::generic_category(), folder.string());
}

FolderLock::~FolderLock() { close(handle_); }

void FolderLock::share() {
    while (flock(handle_, LOCK_SH) != 0 && errno == EINTR) {
    }
}

void FolderLock::take_alone() {
    while (flock(handle_, LOCK_EX) != 0 && errno == EINTR) {
    }
}

fs::path draw_program() { return "app/grade/raylab-draw"; }

BaseBuild prepare_base(const LabSheet& sheet, const fs::path& cache,
                       const sandbox::Isolation& isolation,
                       const std::function<void(const BaseBuild&)>& built) {
    BaseBuild base;
    base.sheet = sheet;
    base.folder = fs::absolute(cache) / sheet.folder;
    fs::create_directories(base.folder);
    base.lock = std::make_shared<FolderLock>(base.folder);
    const std::string stamp = stamp_of(sheet.root);
    const auto is_done = [&] {
        return read_or_empty(base.folder / "stamp") == stamp &&
               !fs::exists(base.folder / "build.base") && !fs::exists(base.folder / "lab.base");
    };
    base.lock->share();
    if (!is_done() || !isolation.maps) base.lock->take_alone();
    if (!is_done()) put_back(base);
    const bool done = is_done(); // another may have built it meanwhile
    if (!done) {
        fs::remove(base.folder / "stamp");
        fs::remove_all(base.tree()); // a file may have gone; ccache makes the rest quick
        fs::create_directories(base.tree());
        write_student_tree(read_lab_sources(sheet), base.tree());
    }
    base.sheet = read_lab_sheet(base.tree(), sheet.folder);
    if (!done) {
        fmt::print(stderr, "building lab {} with stubs, once for all submissions\n", sheet.number);
        build(base);
        built(base);
        write_file((base.folder / "stamp").string(), stamp);
    }
    if (isolation.maps) base.lock->share();
    return base;
}

} // namespace raylab::grading
