// See expectation.h.
#include "app/run/tests/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace raylab::app {

using simt::Finding;

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
    return parts;
}

namespace {

std::string in_words(const Finding& finding) {
    return fmt::format("{} {} {}: {}", name(finding.severity), finding.place.line, finding.kind,
                       finding.message);
}

Expected read_expected(const std::string& text) {
    std::istringstream words(text);
    std::string modes, lines, kinds;
    Expected expected;
    if (!(words >> modes >> expected.severity >> lines >> kinds))
        throw std::runtime_error("cannot read '" + text + "'");
    for (const std::string& kind : split(kinds, '|')) expected.kinds.insert(kind);
    for (const std::string& mode : split(modes, ',')) expected.modes.insert(mode);
    for (const std::string& line : split(lines, '|')) expected.lines.insert(std::stoi(line));
    return expected;
}

} // namespace

bool Expected::is_met_by(const Finding& finding) const {
    return kinds.count(finding.kind) > 0 && name(finding.severity) == severity &&
           (lines.count(finding.place.line) > 0 ||
            (finding.other && lines.count(finding.other->place.line) > 0)); // either end of a race
}

bool CorpusFile::expects(const std::string& mode) const {
    return std::any_of(expected.begin(), expected.end(),
                       [&](const Expected& e) { return e.modes.count(mode) > 0; });
}

std::vector<std::string> CorpusFile::missing(const std::string& mode,
                                             const std::vector<Finding>& findings) const {
    std::vector<std::string> list;
    for (const Expected& e : expected) {
        if (e.modes.count(mode) == 0) continue;
        if (std::none_of(findings.begin(), findings.end(),
                         [&](const Finding& finding) { return e.is_met_by(finding); }))
            list.push_back(fmt::format("{} {} {}", e.severity, *e.lines.begin(), *e.kinds.begin()));
    }
    return list;
}

std::vector<std::string> CorpusFile::surplus(const std::vector<Finding>& findings) const {
    std::vector<std::string> list;
    const auto follows = [&](const Finding& finding) { // from whatever is wrong
        return finding.kind == "order-dependence" && !expected.empty();
    };
    for (const Finding& finding : findings)
        if (!follows(finding) && finding.severity != simt::Severity::note &&
            !(finding.kind == known_alarm && finding.mode == "races") &&
            std::none_of(expected.begin(), expected.end(), [&](const Expected& e) {
                return e.lines.count(finding.place.line) > 0 ||
                       (finding.other && e.lines.count(finding.other->place.line) > 0);
            }))
            list.push_back(in_words(finding));
    return list;
}

std::vector<CorpusFile> read_corpus(const std::filesystem::path& folder) {
    std::vector<CorpusFile> corpus;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".cu") continue;
        std::ifstream file(entry.path());
        std::string line;
        std::getline(file, line);
        const std::string start = "// expect: ";
        if (!line.starts_with(start))
            throw std::runtime_error(entry.path().string() + ": the first line expects nothing");
        CorpusFile read{entry.path(), {}, {}};
        if (const std::string yet = start + "nothing (yet "; line.starts_with(yet))
            read.known_alarm = line.substr(yet.size(), line.size() - yet.size() - 1);
        else if (line != start + "nothing")
            for (const std::string& part : split(line.substr(start.size()), ';'))
                read.expected.push_back(read_expected(part));
        corpus.push_back(read);
    }
    std::sort(corpus.begin(), corpus.end(),
              [](const CorpusFile& a, const CorpusFile& b) { return a.path < b.path; });
    return corpus;
}

} // namespace raylab::app
