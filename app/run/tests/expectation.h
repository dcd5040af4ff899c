// What a file of the corpus says about itself, in its first line:
//
//     // expect: nothing
//     // expect: nothing (yet KIND)       a false alarm of the mode races that is known
//     // expect: MODES SEVERITY LINES KIND; MODES SEVERITY LINES KIND ...
//     // expect: plain,races error 9 shared-overrun; bounds error 9 out-of-bounds
//
// MODES: plain, watch, bounds, races, order (of `raylab run --machine`), compile (it must not),
// host (clang says so, in every mode), or none: a finding that no mode makes yet. LINES: 8 or 8|9
// (one of them), 0 for a finding without a line. KIND: one, or more with | between, each of which
// names the mistake rightly.
#pragma once

#include "common/simt/finding.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace raylab::app {

struct Expected {
    std::set<std::string> modes, kinds;
    std::string severity;
    std::set<int> lines;
    bool is_met_by(const simt::Finding& finding) const;
};

struct CorpusFile {
    std::filesystem::path path;
    std::vector<Expected> expected; // empty: nothing may be found
    std::string known_alarm;        // but this kind, in the mode races
    std::string name() const { return path.stem().string(); }
    bool expects(const std::string& mode) const;

    // What is expected in this mode, and is not there.
    std::vector<std::string> missing(const std::string& mode,
                                     const std::vector<simt::Finding>& findings) const;

    // Findings at lines that nothing is expected at.
    std::vector<std::string> surplus(const std::vector<simt::Finding>& findings) const;
};

std::vector<std::string> split(const std::string& text, char at);

// Throws std::runtime_error for a first line that cannot be read.
std::vector<CorpusFile> read_corpus(const std::filesystem::path& folder);

} // namespace raylab::app
