#include "grader/course/update_tree.h"

#include "common/cli/files.h"
#include "common/cli/process.h"

#include <optional>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr double merge_limit_seconds = 30;

std::set<std::string> names_below(const fs::path& folder) {
    std::set<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.insert(entry.path().lexically_relative(folder).string());
    return files;
}

// Nothing if there is no such file.
std::optional<std::string> text_of(const fs::path& file) {
    if (!fs::is_regular_file(file)) return {};
    return read_file(file.string());
}

// Both changes of the file in one text, or nothing if they touch each other or no git is there.
std::optional<std::string> both_changes(const fs::path& base, const fs::path& mended,
                                        const fs::path& own) {
    const ProcessResult merge = run_process(
        {"git", "merge-file", "-p", "-q", own.string(), base.string(), mended.string()},
        {.limit_seconds = merge_limit_seconds, .errors = ProcessOptions::Errors::passed_on});
    if (!merge.succeeded()) return {};
    return merge.output;
}

} // namespace

std::vector<FileUpdate> plan_update(const fs::path& base, const fs::path& mended,
                                    const fs::path& own, const std::set<std::string>& task_files) {
    std::set<std::string> files = names_below(base);
    files.merge(names_below(mended));
    std::vector<FileUpdate> updates;
    for (const std::string& file : files) {
        const auto before = text_of(base / file), after = text_of(mended / file),
                   written = text_of(own / file);
        if (after == before || written == after) continue;
        if (written == before) {
            const Fate fate = !after ? Fate::removed : !before ? Fate::added : Fate::replaced;
            updates.push_back({file, fate, after.value_or("")});
            continue;
        }
        if (!after) continue; // changed, but not needed any more: it stays
        std::optional<std::string> merged;
        if (before && written && !task_files.contains(file))
            merged = both_changes(base / file, mended / file, own / file);
        updates.push_back({file, merged ? Fate::merged : Fate::kept, merged ? *merged : *after});
    }
    return updates;
}

void apply_update(const std::vector<FileUpdate>& updates, const fs::path& mended,
                  const fs::path& own) {
    for (const FileUpdate& update : updates) {
        const fs::path target = own / (update.file + (update.fate == Fate::kept ? ".new" : ""));
        if (update.fate == Fate::removed) {
            fs::remove(target);
            continue;
        }
        fs::create_directories(target.parent_path());
        write_file(target.string(), update.text);
        fs::permissions(target, fs::status(mended / update.file).permissions());
    }
}

const char* name(Fate fate) {
    switch (fate) {
    case Fate::added:
        return "added";
    case Fate::replaced:
        return "replaced";
    case Fate::removed:
        return "removed";
    case Fate::merged:
        return "merged";
    case Fate::kept:
        return "kept";
    }
    return "";
}

} // namespace raylab
