#include "grader/class/similarity.h"

#include "common/cli/files.h"
#include "grader/class/run_class.h"
#include "grader/submissions/source_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::string trimmed(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(" \t");
    return begin == line.npos ? "" : line.substr(begin, line.find_last_not_of(" \t") + 1 - begin);
}

// The table of a longest common subsequence has a row for each line: longer files are no lab's.
constexpr std::size_t most_lines = 5000;

// What students of the lab begin with.
std::string given_text(const LabSources& lab, const std::string& file) {
    const MarkedSource* source = lab.find(file);
    return source ? student_source(*source, [](const auto&) { return true; }) : "";
}

} // namespace

std::string own_lines(const std::string& text, const std::string& given) {
    std::vector<std::string> own = lines_of(text), other = lines_of(given);
    if (own.size() > most_lines) own.resize(most_lines);
    std::vector<std::string> a, b;
    for (const std::string& line : own) a.push_back(trimmed(line));
    for (const std::string& line : other) b.push_back(trimmed(line));
    // length[i][j]: of the longest common subsequence of a from i on and b from j on
    const std::size_t width = b.size() + 1;
    std::vector<int> length((a.size() + 1) * width, 0);
    for (std::size_t i = a.size(); i-- > 0;)
        for (std::size_t j = b.size(); j-- > 0;)
            length[i * width + j] =
                a[i] == b[j] ? 1 + length[(i + 1) * width + j + 1]
                             : std::max(length[(i + 1) * width + j], length[i * width + j + 1]);
    std::string result;
    for (std::size_t i = 0, j = 0; i < a.size();) {
        if (j < b.size() && a[i] == b[j]) {
            ++i, ++j;
        } else if (j < b.size() && length[i * width + j + 1] >= length[(i + 1) * width + j]) {
            ++j;
        } else {
            result += own[i++] + "\n";
        }
    }
    return result;
}

int export_own_lines(const Journal& journal, const LabSources& lab, const fs::path& folder,
                     const fs::path& target) {
    if (fs::exists(target) && !fs::is_empty(target))
        throw FileError(fmt::format("'{}' is not empty: name another folder", target.string()),
                        ExitCode::bad_usage);
    int count = 0;
    journal.each(Set::live, [&](const JournalRow& row) {
        if (row.hash.empty()) return;
        for (const std::string& file : lab.sheet.files()) {
            const fs::path sent = files_of(folder, row.hash) / file;
            if (!fs::exists(sent)) continue;
            const std::string own =
                own_lines(read_sent_file(sent, file, UnpackLimits().source), given_text(lab, file));
            if (own.empty()) continue;
            const fs::path written =
                target / row.id / (file.ends_with(".cu") ? file + ".cpp" : file);
            fs::create_directories(written.parent_path());
            write_file(written.string(), own);
        }
        ++count;
    });
    return count;
}

} // namespace raylab
