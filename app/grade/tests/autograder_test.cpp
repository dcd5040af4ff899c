// The packages of `raylab autograder`, and what platforms start of them, in the folders that
// platforms have, with a program in raylab's place that writes marks, crashes, hangs or does
// nothing.
#include "app/tests/shell.h"
#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"
#include "grader/results/formats.h"
#include "grader/results/tests/platform_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>

namespace raylab {
namespace {

namespace fs = std::filesystem;

using app::Outcome;
using app::run_in_shell;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr int owner_alone = 0600;

int permissions(const fs::path& file) {
    return static_cast<int>(fs::status(file).permissions() & fs::perms::mask);
}

Outcome autograder(const std::string& options) {
    return run_in_shell(std::string(RAYLAB_GRADE_PROGRAM) + " autograder " + options);
}

// The package of lab 02 for a platform, made once.
const fs::path& package(const std::string& platform) {
    static const TemporaryFolder folder;
    static std::map<std::string, fs::path> made;
    fs::path& place = made[platform];
    if (place.empty()) {
        place = folder / platform;
        const Outcome outcome =
            autograder(fmt::format("02 --for {} -o '{}'", platform, place.string()));
        EXPECT_EQ(outcome.code, 0) << outcome.text;
    }
    return place;
}

std::set<std::string> files_of(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder));
    return names;
}

// Two of three tasks, 20 of 30 points; `trouble`: the grader was ended then.
Marks marks_with(const std::string& trouble) {
    Marks marks;
    marks.lab = "02_iterative";
    marks.title = "The iterative kernel";
    marks.grader = "stand-in";
    marks.trouble = trouble;
    for (int i = 1; i <= 3; ++i) {
        Mark mark;
        mark.id = "2." + std::to_string(i);
        mark.title = "Task";
        mark.of_points = 10;
        mark.verdict = i < 3 ? MarkVerdict::pass : MarkVerdict::wrong;
        marks.tasks.push_back(mark);
    }
    return marks;
}

// Stands for the script `raylab`. It logs its arguments, and does what the file `deed` says; for
// each FORMAT of --write FORMAT:FILE it has marks beside it.
constexpr std::string_view stand_in = R"sh(#!/usr/bin/env bash
here=$(dirname -- "$(readlink -f -- "$0")")
echo "$@" >>"$here/log"
deed=$(cat "$here/deed")
if [ "$1" = doctor ]; then [ "$deed" != no_doctor ]; exit; fi
give() { # marks or trouble
    while [ $# -gt 1 ]; do
        if [ "$2" = --write ]; then cp "$here/$1.${3%%:*}" "${3#*:}"; fi
        set -- "$1" "${@:3}"
    done
}
case $deed in
    right) give marks "$@" ;;
    half) give marks "$@"; exit 1 ;;
    crash) give trouble "$@"; kill -SEGV $$ ;;
    crash_at_once) kill -SEGV $$ ;;
    hang) give trouble "$@"; sleep 60 ;;
    hang_at_once) sleep 60 ;;
    trouble) give trouble "$@"; exit 3 ;;
    garbage) echo '{"score": 1' >result.json ;;
    nothing) ;;
esac
)sh";

void write_stand_in(const fs::path& folder) {
    fs::create_directories(folder);
    write_file((folder / "raylab").string(), stand_in);
    fs::permissions(folder / "raylab", fs::perms::owner_all);
    for (const char* format : {"gradescope", "prairielearn", "classroom50", "summary"}) {
        write_file((folder / "marks").string() + "." + format, write_marks(format, marks_with("")));
        write_file((folder / "trouble").string() + "." + format,
                   write_marks(format, marks_with("the grader was stopped")));
    }
} // namespace

// A platform that grades: where its machine has the files, and what it starts.
struct Machine {
    std::string platform, secrets, run, submission;
};
const Machine machines[] = {{"gradescope", ".", "run_autograder", "submission"},
                            {"prairielearn", "image", "run.sh", "student"}};

// The machine when setup.sh has run, with the stand-in for the grader.
class Prepared {
  public:
    explicit Prepared(const Machine& machine) : machine_(machine) {
        fs::create_directories(source());
        for (const std::string& name : {machine.run, std::string("internal.json")})
            fs::copy_file(package(machine.platform) / machine.secrets / name, source() / name);
        write_stand_in(source() / "tree");
        fs::create_directories(folder_ / machine.submission);
    }

    // What the file of results says after a grading.
    std::string results(const std::string& deed, const std::string& limit = "20") {
        write_file((source() / "tree/deed").string(), deed);
        fs::remove_all(folder_ / "results");
        outcome = run_in_shell(fmt::format("'{}' '{}' '{}' {}", (source() / machine_.run).string(),
                                           folder_.path().string(), source().string(), limit));
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        EXPECT_EQ(files_of(folder_ / "results"), std::set<std::string>{"results.json"});
        return read_file((folder_ / "results/results.json").string());
    }
    json checked(const std::string& text) const {
        return machine_.platform == "gradescope" ? expect_gradescope(text)
                                                 : expect_prairielearn(text);
    }
    std::string log() const { return read_file((source() / "tree/log").string()); }
    fs::path root() const { return folder_.path(); }
    fs::path source() const { return folder_ / "source"; }
    Outcome outcome{};

  private:
    TemporaryFolder folder_;
    Machine machine_;
};

TEST(Autograder, PackagesHaveTheirFiles) {
    EXPECT_EQ(files_of(package("gradescope")),
              (std::set<std::string>{"README.md", "setup.sh", "run_autograder", "raylab.tar.gz",
                                     "internal.json", "key"}));
    EXPECT_EQ(files_of(package("prairielearn")),
              (std::set<std::string>{"README.md", "question/info.json", "question/question.html",
                                     "image/Dockerfile", "image/setup.sh", "image/run.sh",
                                     "image/raylab.tar.gz", "image/internal.json", "image/key"}));
    // What Classroom 50 publishes: no solutions and no key.
    EXPECT_EQ(files_of(package("classroom50")),
              (std::set<std::string>{"README.md", "autograder.py", "assignment.json"}));
    for (const char* platform : {"gradescope", "prairielearn", "classroom50"}) {
        EXPECT_EQ(permissions(package(platform)), 0700) << platform;
        for (const std::string& name : files_of(package(platform)))
            if (!name.ends_with(".gz") && !name.ends_with("key")) {
                EXPECT_THAT(read_file((package(platform) / name).string()),
                            Not(testing::ContainsRegex("@[A-Z0-9]+@")))
                    << name;
            }
    }
}

TEST(Autograder, EachPackageHasAKeyOfItsOwnThatItsOwnerAloneCanRead) {
    const fs::path one = package("gradescope") / "key", two = package("prairielearn") / "image/key";
    EXPECT_EQ(permissions(one), owner_alone);
    EXPECT_EQ(permissions(two), owner_alone);
    EXPECT_EQ(fs::file_size(one), 32u);
    EXPECT_NE(read_file(one.string()), read_file(two.string()));
}

TEST(Autograder, TheTreeThatIsPackedHasWhatBuildsTheGrader) {
    const Outcome list =
        run_in_shell(fmt::format("tar -tzf '{}/raylab.tar.gz'", package("gradescope").string()));
    EXPECT_EQ(list.code, 0);
    for (const char* file :
         {"raylab\n", "packages.txt\n", "CMakePresets.json\n", "app/grade/main.cpp\n",
          "grader/sandbox/sandbox.h\n", "labs/02_iterative/path.h\n", "scenes/cornell.json\n"})
        EXPECT_THAT("\n" + list.text, HasSubstr(std::string("\n") + file));
    EXPECT_THAT("\n" + list.text, Not(HasSubstr("\nbuild/")));
    EXPECT_THAT("\n" + list.text, Not(HasSubstr("\n.git/")));
}

TEST(Autograder, ScriptsAreWithoutMistakes) {
    for (const char* script : {"gradescope/setup.sh", "gradescope/run_autograder",
                               "prairielearn/image/setup.sh", "prairielearn/image/run.sh"}) {
        const std::string name = script;
        const fs::path file =
            package(name.substr(0, name.find('/'))) / name.substr(name.find('/') + 1);
        EXPECT_EQ(permissions(file), 0755) << script;
        const Outcome outcome = run_in_shell(fmt::format(
            "bash -n '{0}' && {{ ! command -v shellcheck >/dev/null || shellcheck '{0}'; }}",
            file.string()));
        EXPECT_EQ(outcome.code, 0) << script << "\n" << outcome.text;
    }
    EXPECT_EQ(permissions(package("classroom50") / "autograder.py"), 0755);
}

TEST(Autograder, MarksReachThePlatform) {
    for (const Machine& machine : machines) {
        SCOPED_TRACE(machine.platform);
        Prepared prepared(machine);
        const bool whole_points = machine.platform == "gradescope";
        for (const char* deed : {"right", "half"}) {
            const json file = prepared.checked(prepared.results(deed));
            EXPECT_NEAR(file["score"].get<double>(), whole_points ? 20 : 20.0 / 30, 1e-12);
            EXPECT_EQ(file["tests"].size(), 3u);
        }
        const std::string root = prepared.root().string();
        EXPECT_THAT(prepared.log(), testing::MatchesRegex(fmt::format(
                                        "(grade 02 {0}/{1} -o /[^ ]+ --key {0}/source/key --write "
                                        "{2}:{0}/results/results.json\n)+",
                                        root, machine.submission, machine.platform)));
    }
}

// What was known before the end stays; before there was anything, the package's own file.
TEST(Autograder, TheFileSaysInternalWhateverHappensToTheGrader) {
    for (const Machine& machine : machines) {
        SCOPED_TRACE(machine.platform);
        Prepared prepared(machine);
        const auto says = [&](const std::string& deed, const std::string& limit,
                              const std::string& words, std::size_t tasks) {
            SCOPED_TRACE(deed);
            const std::string text = prepared.results(deed, limit);
            const json file = prepared.checked(text);
            EXPECT_THAT(text, HasSubstr("INTERNAL"));
            EXPECT_THAT(text, HasSubstr(words));
            EXPECT_EQ(file["tests"].size(), tasks);
            if (machine.platform == "prairielearn") {
                EXPECT_EQ(file["gradable"], false);
            }
        };
        says("crash", "20", "was stopped", 3);
        EXPECT_THAT(prepared.outcome.text, HasSubstr("exit code 139"));
        says("trouble", "20", "was stopped", 3);
        if (machine.platform == "gradescope") {  // the platforms' scripts have one template
            says("hang", "2", "was stopped", 3); // time to write on a busy machine
            EXPECT_THAT(prepared.outcome.text, HasSubstr("was ended after 2 s"));
        }
        says("crash_at_once", "20", "came to no result", 6);
        says("hang_at_once", ".2", "came to no result", 6);
        says("nothing", "20", "came to no result", 6);
        fs::remove_all(prepared.source() / "tree"); // nothing that could be started
        fs::create_directories(prepared.source() / "tree");
        says("right", "20", "came to no result", 6);
    }
}

// Else the script `raylab` would compile anew whatever an image has unpacked.
TEST(Autograder, ABuildOfAnImageStaysOfUse) {
    Prepared prepared(machines[0]);
    const fs::path log = prepared.source() / "tree/build/cpu/.ninja_log";
    fs::create_directories(log.parent_path());
    write_file(log.string(), "");
    const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
    fs::last_write_time(log, long_ago);
    prepared.results("right");
    EXPECT_GT(fs::last_write_time(log), long_ago + std::chrono::minutes(30));
}

// setup.sh with an archive that has the stand-in in place of the tree.
Outcome set_up(const TemporaryFolder& folder, const std::string& deed) {
    write_stand_in(folder / "stand_in");
    folder.write("stand_in/deed", deed);
    fs::create_directories(folder / "stand_in/cmake");
    fs::copy_file(fs::path(RAYLAB_ROOT) / "cmake/RaylabFlags.cmake",
                  folder / "stand_in/cmake/RaylabFlags.cmake");
    fs::create_directories(folder / "source");
    fs::copy_file(package("gradescope") / "setup.sh", folder / "source/setup.sh");
    folder.write("source/key", "key"); // others can read it: a zip may lose its permissions
    return run_in_shell(fmt::format("cd '{0}' && tar -czf source/raylab.tar.gz -C stand_in . && "
                                    "source/setup.sh '{0}/source'",
                                    folder.path().string()));
}

TEST(Autograder, SetupBuildsTheGraderForAnyProcessorAndTriesTheSolution) {
    const TemporaryFolder folder;
    const Outcome outcome = set_up(folder, "right");
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    const std::string source = (folder / "source").string();
    EXPECT_EQ(
        read_file(source + "/tree/log"),
        fmt::format("doctor\ngrade 02 labs/02_iterative -o {0}/solution --key {0}/key\n", source));
    EXPECT_EQ(permissions(folder / "source/key"), owner_alone);
#if defined(__x86_64__)
    EXPECT_THAT(read_file(source + "/tree/cmake/RaylabFlags.cmake"),
                HasSubstr("\nset(RAYLAB_ARCH x86-64-v3 CACHE"));
#endif
}

TEST(Autograder, SetupFailsIfTheSolutionHasNotAllPointsOrTheGraderIsNotBuilt) {
    for (const char* deed : {"half", "trouble", "crash", "no_doctor"}) {
        const TemporaryFolder folder;
        EXPECT_NE(set_up(folder, deed).code, 0) << deed;
    }
}

TEST(Autograder, PrairieLearnKnowsWhatToStart) {
    const json info = json::parse(read_file((package("prairielearn") / "question/info.json")));
    const json& grading = info.at("externalGradingOptions");
    EXPECT_EQ(keys(grading), (std::set<std::string>{"enabled:boolean", "image:string",
                                                    "entrypoint:string", "timeout:number"}));
    EXPECT_EQ(grading.at("entrypoint"), "/raylab/run.sh");
    EXPECT_LE(grading.at("timeout"), 600);
    EXPECT_EQ(info.at("gradingMethod"), "External");
    EXPECT_THAT(info.at("uuid").get<std::string>(),
                testing::MatchesRegex("[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-a[0-9a-f]{3}-"
                                      "[0-9a-f]{12}"));
    EXPECT_THAT(read_file(package("prairielearn") / "image/Dockerfile"),
                HasSubstr("\nRUN /raylab/setup.sh /raylab\n"));
}

// Classroom 50 runs autograder.py in a student's checkout.
class Checkout {
  public:
    Checkout() { write_stand_in(folder_.path()); }

    int run(const std::string& deed, const std::string& limit = "") {
        folder_.write("deed", deed);
        folder_.write("result.json", "{\"score\": 100}"); // as a student could leave them
        folder_.write("release-body.md", "100 points");
        outcome = run_in_shell(fmt::format(
            "cd '{}' && CLASSROOM=c ASSIGNMENT=a SUBMISSION_TAG=t COMMIT_URL=u RELEASE_URL=u "
            "REVIEW_URL=u OWNER=o '{}/autograder.py' {}",
            folder_.path().string(), package("classroom50").string(), limit));
        return outcome.code;
    }
    bool has(const std::string& name) const { return fs::exists(folder_ / name); }
    std::string text(const std::string& name) const { return read_file((folder_ / name).string()); }
    fs::path operator/(const std::string& name) const { return folder_ / name; }
    Outcome outcome{};

  private:
    TemporaryFolder folder_;
};

TEST(Autograder, Classroom50GetsTheMarksOfACheck) {
    Checkout checkout;
    for (const char* deed : {"right", "half"}) {
        EXPECT_EQ(checkout.run(deed), 0) << checkout.outcome.text;
        const json file = expect_classroom50(checkout.text("result.json"));
        EXPECT_EQ(file["score"], 20);
        EXPECT_THAT(checkout.text("release-body.md"), HasSubstr("2.3 Task"));
    }
    EXPECT_THAT(checkout.text("log"), HasSubstr("check 02 --write classroom50:result.json"));
}

TEST(Autograder, Classroom50PublishesNothingWhenTheCheckHasTrouble) {
    Checkout checkout;
    const auto publishes_nothing = [&](const std::string& deed, const std::string& limit = "") {
        EXPECT_EQ(checkout.run(deed, limit), 1) << deed << "\n" << checkout.outcome.text;
        EXPECT_FALSE(checkout.has("result.json")) << deed;
        EXPECT_FALSE(checkout.has("release-body.md")) << deed;
        EXPECT_THAT(checkout.outcome.text, HasSubstr("INTERNAL: ")) << deed;
    };
    for (const char* deed : {"crash", "crash_at_once", "trouble", "nothing", "garbage"})
        publishes_nothing(deed);
    publishes_nothing("hang", ".2");
    publishes_nothing("hang_at_once", ".2");
    fs::remove(checkout / "raylab");
    publishes_nothing("right");
}

TEST(Autograder, Classroom50InstallsThePackagesAndAllowsTheLabsFiles) {
    const json assignment = json::parse(read_file(package("classroom50") / "assignment.json"));
    const json& packages = assignment.at("runtime").at("apt");
    for (const char* name : {"g++", "libboost-context-dev", "libsqlite3-dev"})
        EXPECT_THAT(packages, testing::Contains(name));
    EXPECT_THAT(assignment.at("allowed_files"), testing::Contains("labs/02_iterative/path.h"));
}

TEST(Autograder, WrongUsageIsRefused) {
    const TemporaryFolder folder;
    folder.write("there", "");
    const std::string out = (folder / "out").string();
    const auto refused = [&](const std::string& options, const std::string& words) {
        const Outcome outcome = autograder(options);
        EXPECT_EQ(outcome.code, 2) << outcome.text;
        EXPECT_THAT(outcome.text, HasSubstr(words));
    };
    refused("02 --for gradscope -o " + out, "did you mean \"gradescope\"");
    refused("09 --for gradescope -o " + out, "no lab '09'");
    refused("02 --for gradescope", "--output");
    refused("02 --for gradescope -o " + folder.path().string(), "is there already");
    EXPECT_EQ(files_of(folder.path()), std::set<std::string>{"there"});
    const Outcome help = autograder("--help");
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.text, HasSubstr("Examples"));
}

} // namespace
} // namespace raylab
