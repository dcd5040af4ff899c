// Read from the platforms' documents, autumn 2026.
#include "app/grade/autograder/platform.h"

#include "common/cli/files.h"
#include "common/load/suggest.h"

#include <fmt/format.h>

namespace raylab::app {

const std::vector<Platform>& platforms() {
    // The limits leave time for the last words before the platform's own limit: on Gradescope the
    // one that README.md asks for, 1800 s; on PrairieLearn 600 s, the most that there is.
    static const std::vector<Platform> all = {
        {.title = "Gradescope",
         .format = "gradescope",
         .files = {{"README.md", "gradescope.md.in"},
                   {"setup.sh", "setup.sh", true},
                   {"run_autograder", "run.sh", true}},
         .secrets = ".",
         .run = "run_autograder",
         .root = "/autograder",
         .submission = "submission",
         .source = "/autograder/source",
         .limit_seconds = 1700},
        {.title = "PrairieLearn",
         .format = "prairielearn",
         .files = {{"README.md", "prairielearn.md.in"},
                   {"question/info.json", "info.json"},
                   {"question/question.html", "question.html"},
                   {"image/Dockerfile", "Dockerfile"},
                   {"image/setup.sh", "setup.sh", true},
                   {"image/run.sh", "run.sh", true}},
         .secrets = "image",
         .run = "run.sh",
         .root = "/grade",
         .submission = "student",
         .source = "/raylab",
         .limit_seconds = 570},
        {.title = "Classroom 50",
         .format = "classroom50",
         .files = {{"README.md", "classroom50.md.in"},
                   {"autograder.py", "autograder.py", true},
                   {"assignment.json", "assignment.json"}},
         .secrets = {},
         .run = {},
         .root = {},
         .submission = {},
         .source = {},
         .limit_seconds = 1200},
    };
    return all;
}

const Platform& platform_of(const std::string& format) {
    std::vector<std::string> names;
    for (const Platform& platform : platforms()) {
        if (platform.format == format) return platform;
        names.push_back(platform.format);
    }
    throw FileError(fmt::format("--for {}: there is no such platform{}; there are {}", format,
                                did_you_mean(format, names), listed(names)),
                    ExitCode::bad_usage);
}

} // namespace raylab::app
