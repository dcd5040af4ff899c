#include "grader/course/markers.h"

#include <fmt/format.h>

#include <optional>

namespace raylab {

namespace {

constexpr std::string_view open_marker = "//[", close_marker = "//]", bar = "//|";

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == line.npos) return "";
    return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

// "    //| return 0;" -> "    return 0;": the bar and one space go, the indentation stays.
std::string without_bar(const std::string& line) {
    const std::size_t at = line.find(bar);
    std::string rest = line.substr(at + bar.size());
    if (rest.starts_with(' ')) rest.erase(0, 1);
    return rest.empty() ? "" : line.substr(0, at) + rest;
}

class Parser {
  public:
    Parser(std::string_view text, const std::string& file) { source_.file = file, text_ = text; }

    MarkedSource parse() {
        source_.pieces.emplace_back();
        for (const std::string& line : lines_of(text_)) {
            ++line_;
            take(line, trimmed(line));
        }
        if (open_)
            fail(open_->line,
                 fmt::format("this region of {} is never closed: end it with //]", name(*open_)));
        return std::move(source_);
    }

  private:
    void take(const std::string& line, std::string_view word) {
        if (word.starts_with(open_marker)) {
            if (open_)
                fail(line_, fmt::format("a region opens inside that of {} from line {}: close "
                                        "that one first, with //]",
                                        name(*open_), open_->line));
            open_ = opened(word);
        } else if (word.starts_with(close_marker)) {
            if (!open_) fail(line_, "//] closes a region, but none is open here");
            if (word != close_marker) fail(line_, "//] stands alone on its line");
            source_.pieces.back().region.push_back(std::move(*open_));
            source_.pieces.emplace_back();
            open_.reset();
        } else if (word.starts_with(bar)) {
            if (!open_) fail(line_, "//| begins a line of a stub, but no region is open here");
            open_->stub.push_back(without_bar(line));
        } else if (open_) {
            if (!open_->stub.empty())
                fail(line_, fmt::format("a line of the solution stands behind the stub of {}: "
                                        "first the solution, then the lines with //|",
                                        name(*open_)));
            open_->solution.push_back(line);
        } else {
            source_.pieces.back().lines.push_back(line);
        }
    }

    MarkedRegion opened(std::string_view word) const {
        for (const auto& [kind, prefix] :
             {std::pair{MarkedRegion::Kind::task, "//[ task "},
              std::pair{MarkedRegion::Kind::withhold, "//[ withhold "}}) {
            if (!word.starts_with(prefix)) continue;
            const std::string id(word.substr(std::string_view(prefix).size()));
            if (!id.empty() && id.find_first_not_of("0123456789.") == id.npos)
                return {kind, id, line_, {}, {}};
        }
        fail(line_, fmt::format("expected //[ task 2.3 or //[ withhold 01, found {}", word));
    }

    static std::string name(const MarkedRegion& region) {
        return (region.kind == MarkedRegion::Kind::task ? "task " : "withhold ") + region.id;
    }

    [[noreturn]] void fail(int line, const std::string& what) const {
        throw CourseError(fmt::format("{}:{}: {}", source_.file, line, what));
    }

    MarkedSource source_;
    std::string_view text_;
    int line_ = 0;
    std::optional<MarkedRegion> open_;
};

} // namespace

std::vector<const MarkedRegion*> MarkedSource::regions() const {
    std::vector<const MarkedRegion*> all;
    for (const Piece& piece : pieces)
        for (const MarkedRegion& region : piece.region) all.push_back(&region);
    return all;
}

MarkedSource parse_markers(std::string_view text, const std::string& file) {
    return Parser(text, file).parse();
}

std::string student_source(const MarkedSource& source,
                           const std::function<bool(const MarkedRegion&)>& stubbed) {
    std::string text;
    const auto append = [&](const std::vector<std::string>& lines) {
        for (const std::string& line : lines) text.append(line).append("\n");
    };
    for (const MarkedSource::Piece& piece : source.pieces) {
        append(piece.lines);
        for (const MarkedRegion& region : piece.region)
            append(stubbed(region) ? region.stub : region.solution);
    }
    return text;
}

} // namespace raylab
