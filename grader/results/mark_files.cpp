#include "grader/results/mark_files.h"

#include "common/cli/files.h"
#include "common/load/suggest.h"
#include "grader/results/formats.h"

#include <fmt/format.h>

namespace raylab {

MarkFiles::MarkFiles(const std::vector<std::string>& asked) {
    for (const std::string& text : asked) {
        const std::size_t colon = text.find(':');
        const std::string format = text.substr(0, colon);
        if (colon == text.npos || colon + 1 == text.size())
            throw FileError(fmt::format("--write {}: expected FORMAT:FILE", text),
                            ExitCode::bad_usage);
        const std::vector<std::string>& known = mark_formats();
        if (std::find(known.begin(), known.end(), format) == known.end())
            throw FileError(fmt::format("--write {}: there is no format '{}'{}; the formats are {}",
                                        text, format, did_you_mean(format, known), listed(known)),
                            ExitCode::bad_usage);
        files_.emplace_back(format, text.substr(colon + 1));
        prepare_output(files_.back().second);
    }
}

void MarkFiles::write(const Marks& marks) const {
    for (const auto& [format, file] : files_) write_file(file, write_marks(format, marks));
}

} // namespace raylab
