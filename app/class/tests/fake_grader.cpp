// Stands for `raylab grade` in tests: quick, and it does what the submission says.
//
// Called as: fake_grader grade LAB FOLDER -o DIR. The first word of FOLDER/path.h is the deed; each
// run adds a line "begin WORD" or "end WORD" to the file that FAKE_LOG names.
#include "common/cli/files.h"
#include "grader/results/marks_json.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace {

void log(const std::string& line) {
    if (const char* file = std::getenv("FAKE_LOG"))
        std::ofstream(file, std::ios::app) << line << "\n" << std::flush;
}

// "right" passes all tasks, "half" every other one; FAKE_BETTER makes half of them right.
raylab::Marks marks_for(const std::string& lab, const std::string& deed, const std::string& word) {
    raylab::Marks marks;
    marks.lab = lab;
    marks.title = "fake";
    marks.grader = "fake 1";
    marks.sandbox = "none";
    const int points[] = {30, 15, 15, 15, 15, 10};
    for (int i = 0; i < 6; ++i) {
        raylab::Mark mark;
        mark.id = "2." + std::to_string(i + 1);
        mark.title = "task";
        mark.of_points = points[i];
        const bool passes = deed == "right" || std::getenv("FAKE_BETTER") || i % 2 == 0;
        mark.verdict = passes ? raylab::MarkVerdict::pass : raylab::MarkVerdict::wrong_image;
        if (!passes)
            mark.reasons = {"6." + word + " sigma; the likely cause: a factor " + word + " of pi"};
        marks.tasks.push_back(mark);
    }
    if (deed == "trouble" && !std::getenv("FAKE_BETTER"))
        marks.trouble = "the sandbox did not start";
    return marks;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 6 || std::string(argv[1]) != "grade" || std::string(argv[4]) != "-o") return 2;
    const std::string folder = argv[3], out = argv[5];
    std::istringstream words(raylab::read_file(folder + "/path.h"));
    std::string deed, word;
    words >> deed >> word;
    log("begin " + word);
    const char* pause = std::getenv("FAKE_SECONDS");
    std::this_thread::sleep_for(std::chrono::duration<double>(pause ? std::atof(pause) : 0));
    const bool better = std::getenv("FAKE_BETTER");
    if (deed == "hang" && !better) std::this_thread::sleep_for(std::chrono::hours(1));
    if (deed == "crash" && !better) std::abort();
    if (deed == "killed" && !better) kill(getpid(), SIGKILL);
    if (deed == "refuse") return 2;
    if (deed == "none") return 0;
    const std::string text = raylab::marks_json(marks_for(argv[2], deed, word));
    const bool cut = deed == "cut", foreign = deed == "foreign";
    std::ofstream(out + "/marks.json")
        << (cut       ? text.substr(0, text.size() / 2)
            : foreign ? raylab::marks_json(marks_for("03_wavefront", deed, word))
                      : text);
    log("end " + word);
    return deed == "trouble" && !better ? 3 : deed == "right" ? 0 : 1;
}
