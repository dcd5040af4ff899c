#include "common/simt/finding_text.h"

namespace raylab::simt {

static std::string triple(const Index3& index) {
    return "(" + std::to_string(index[0]) + "," + std::to_string(index[1]) + "," +
           std::to_string(index[2]) + ")";
}

std::string in_words(const SourcePlace& place) {
    std::string text = place.file.empty() ? "(no line is known)" : place.file;
    if (place.line > 0) text += ":" + std::to_string(place.line);
    if (place.line > 0 && place.column > 0) text += ":" + std::to_string(place.column);
    return text;
}

std::string in_words(const Actor& actor) {
    std::string text;
    if (!actor.kernel.empty()) text = "kernel " + actor.kernel;
    if (actor.block) text += (text.empty() ? "block " : ", block ") + triple(*actor.block);
    if (actor.thread) text += (text.empty() ? "thread " : ", thread ") + triple(*actor.thread);
    return text;
}

std::string other_end(const Finding& finding) {
    const Finding::Other& other = *finding.other;
    const bool same = other.place == finding.place;
    std::string text = same ? "other end: this line too" : "other end: " + in_words(other.place);
    if (!other.what.empty()) text += ", " + other.what;
    const std::string who = in_words(other.actor);
    return who.empty() ? text : text + ", by " + who;
}

std::string to_text(const Finding& finding) {
    std::string text =
        in_words(finding.place) + ": " + name(finding.severity) + ": " + finding.message + "\n";
    const auto add = [&text](const std::string& line) {
        if (!line.empty()) text += "    " + line + "\n";
    };
    add(in_words(finding.actor));
    if (finding.other) add(other_end(finding));
    if (!finding.advice.empty()) add("to mend it: " + finding.advice);
    if (finding.count > 1) add("seen " + std::to_string(finding.count) + " times");
    return text;
}

} // namespace raylab::simt
