#include "grader/results/marks.h"

namespace raylab {

const char* name(MarkVerdict verdict) {
    switch (verdict) {
    case MarkVerdict::not_run:
        return "NOT_RUN";
    case MarkVerdict::not_implemented:
        return "NOT_IMPLEMENTED";
    case MarkVerdict::compile_error:
        return "COMPILE_ERROR";
    case MarkVerdict::wrong:
        return "WRONG";
    case MarkVerdict::pass:
        return "PASS";
    }
    return "";
}

std::string explanation(const Mark& mark) {
    std::string text;
    for (const std::string& reason : mark.reasons) text += reason + "\n";
    if (mark.verdict != MarkVerdict::pass && !mark.read_on.empty())
        text += "read on in the handout: " + mark.read_on + "\n";
    return text;
}

} // namespace raylab
