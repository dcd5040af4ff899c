// A class of made submissions, and `raylab grade-class` on it with a grader that is quick.
#pragma once

#include "app/tests/shell.h"
#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"

#include <fmt/format.h>

#include <map>
#include <regex>
#include <string>

namespace raylab {

class ClassInFolder {
  public:
    // The first word of a student's path.h says what the grader does (fake_grader.cpp).
    void student(const std::string& name, const std::string& deed) {
        std::filesystem::create_directories(folder_ / ("subs/" + name));
        folder_.write("subs/" + name + "/path.h", deed + " " + name + "\n");
    }
    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    std::string text(const std::string& name) const { return read_file((folder_ / name).string()); }
    void write(const std::string& name, std::string_view bytes) { folder_.write(name, bytes); }

    // The command with these options; `environment`: "FAKE_SECONDS=0.1 ".
    std::string command(const std::string& options, const std::string& environment = "") const {
        return fmt::format("{}FAKE_LOG='{}' {} grade-class 02 --grader {} -o '{}' {}", environment,
                           (folder_ / "log").string(), RAYLAB_CLASS_PROGRAM, RAYLAB_FAKE_GRADER,
                           (folder_ / "out").string(), options);
    }
    app::Outcome run(const std::string& options, const std::string& environment = "") const {
        return app::run_in_shell(command(options, environment));
    }
    app::Outcome run_all(const std::string& options = "",
                         const std::string& environment = "") const {
        return run("'" + (folder_ / "subs").string() + "' " + options, environment);
    }

    // marks.csv without the times of day.
    std::string marks() const {
        return std::regex_replace(text("out/marks.csv"), std::regex("20..-..-..T..:..:..Z"),
                                  "TIME");
    }
    // "score verdict" by the name of the submission.
    std::map<std::string, std::string> verdicts() const {
        static const std::regex row(
            R"re("([^"]*)","[^"]*","[^"]*","[^"]*",[a-z]*,"02_iterative",([0-9]*),100,([A-Z_]+),.*)re");
        std::map<std::string, std::string> found;
        std::istringstream lines(text("out/marks.csv"));
        std::smatch match;
        for (std::string line; std::getline(lines, line);) {
            if (line.ends_with('\r')) line.pop_back();
            if (std::regex_match(line, match, row))
                found[match[1]] = match[2].str() + " " + match[3].str();
        }
        return found;
    }
    // How often a line stands in the grader's log.
    int logged(const std::string& line) const {
        int count = 0;
        std::ifstream lines(folder_ / "log");
        for (std::string one; std::getline(lines, one);) count += one == line;
        return count;
    }

  private:
    TemporaryFolder folder_;
};

} // namespace raylab
