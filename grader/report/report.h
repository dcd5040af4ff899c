// What a run found, written for people (report.html) and for programs (results.json).
//
// report.html is one file without any external address: pictures lie inside it, a content security
// policy forbids everything else, and all text is escaped. Its view is in the address behind '#'.
#pragma once

#include "common/image/image.h"
#include "grader/judge/verdict.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace raylab {

struct Fact {
    std::string label, value; // "samples a pixel", "256"
};

// One renderer's picture of one scene, and what was judged of it.
struct ReportEntry {
    std::string scene, title, reason; // entries of the same scene should follow each other
    std::string lab;
    bool passed = false;         // all of the verdicts below
    bool decided = true;         // false: what is known cannot decide; the verdict says what would
    Verdict verdict;             // the main one, of image and reference
    std::vector<Verdict> checks; // further ones: closed forms, the same paths as another lab
    double seconds = 0;
    std::vector<Fact> facts;               // shown as they are
    std::optional<Image> image, reference; // difference and z-map are made from both
    std::vector<double> lanes_alive;       // share of lanes alive at each bounce, 0 to 1
    nlohmann::json details;                // the judgements in full, for results.json
};

// Whether there are an image and a reference of the same size, so that they are shown together,
// with what the verdict measured of them.
bool has_pair(const ReportEntry& entry);

struct Report {
    std::string title;   // "raylab demo"
    std::string machine; // "AMD ..., 2 cores, g++ 12.2"
    std::string command; // what was run
    std::vector<ReportEntry> entries;
};

// The whole page.
std::string report_html(const Report& report);

// The same facts without the pictures.
nlohmann::json report_json(const Report& report);

// Writes report.html and results.json into `folder`, which is made if need be. Throws FileError.
void write_report(const Report& report, const std::string& folder);

} // namespace raylab
