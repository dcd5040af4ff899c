#include "app/class/enter_class.h"

#include "common/cli/progress.h"
#include "grader/class/run_class.h"
#include "grader/results/text.h"
#include "grader/submissions/submission.h"

#include <fmt/format.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

// A folder that is gone at the end; what a kill has left of it, the next one removes.
struct Scratch {
    fs::path folder;
    explicit Scratch(const fs::path& at) : folder(at) { fs::remove_all(folder); }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
};

JournalRow row_of(const ClassEntry& entry, const LabSheet& sheet, const fs::path& folder,
                  const fs::path& scratch) {
    JournalRow row;
    row.id = entry.id;
    row.students = entry.students;
    row.late = entry.late;
    row.tries = entry.tries;
    try {
        SentFiles sent = read_items(entry.items, entry.id, sheet, scratch);
        row.hash = sent.submission.hash;
        row.missing = sent.submission.missing;
        row.ignored = sent.submission.ignored;
        const fs::path files = files_of(folder, row.hash);
        fs::create_directories(files.parent_path());
        if (!fs::exists(files)) write_submission(std::move(sent), files);
    } catch (const SubmissionError& error) {
        row.refused = clean_utf8(shortened(error.what(), 1000));
    }
    return row;
}

} // namespace

EnteredClass enter_class(const fs::path& submissions, const LabSheet& sheet, const fs::path& folder,
                         Journal& journal) {
    const Scratch scratch(folder / ".unpacked"), one(folder / ".one");
    const ClassExport all = read_class(submissions, sheet, scratch.folder);
    Progress progress("unpacking", static_cast<int>(all.entries.size()), "submissions", 1);
    EnteredClass entered;
    entered.layout = all.layout;
    std::vector<JournalRow> rows;
    for (const ClassEntry& entry : all.entries) {
        rows.push_back(row_of(entry, sheet, folder, one.folder));
        progress.update(++entered.submissions);
    }
    journal.enter(rows);
    constexpr std::size_t told = 5;
    for (const std::string& name : all.unused)
        if (entered.unused.size() < told)
            entered.unused.push_back(clean_utf8(shortened(name, 100)));
    if (all.unused.size() > told)
        entered.unused.push_back(fmt::format("and {} more", all.unused.size() - told));
    return entered;
}

} // namespace raylab::app
