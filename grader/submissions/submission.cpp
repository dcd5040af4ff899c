#include "grader/submissions/submission.h"

#include "common/cli/files.h"
#include "common/cli/sha256.h"
#include "grader/submissions/archive.h"
#include "grader/submissions/pick.h"
#include "grader/submissions/source_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// A folder that is empty at first, and gone in the end. What a kill leaves, the next one removes.
class Workplace {
  public:
    explicit Workplace(const fs::path& folder) : folder_(folder) { fs::remove_all(folder_); }
    ~Workplace() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    fs::path operator/(const std::string& name) const { return folder_ / name; }

  private:
    fs::path folder_;
};

std::vector<Item> items_of_archive(const Item& archive, const LabSheet& sheet,
                                   const fs::path& folder, const UnpackLimits& limits) {
    return unpacked_items(archive.path, archive.name, folder, limits, [&](const Item& item) {
        return could_be_of_lab(item.name, sheet) || is_archive_name(item.name);
    });
}

// What is in the archives among the items, where the items themselves have no file of the lab.
Picked pick_from_archives(const std::vector<Item>& items, const std::string& who,
                          const LabSheet& sheet, const Workplace& work,
                          const UnpackLimits& limits) {
    std::string found;
    Picked best;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Item& item = items[i];
        if (item.kind != Item::Kind::file || !is_archive_name(item.name) || is_junk(item.name))
            continue;
        if (item.path.empty())
            throw SubmissionError(fmt::format("the archive '{}' is not read: it has more than {} "
                                              "bytes; send only the lab's files",
                                              item.name, limits.taken));
        const Picked picked =
            pick_files(items_of_archive(item, sheet, work / std::to_string(i), limits), sheet);
        if (picked.files.empty()) continue;
        if (!found.empty())
            throw SubmissionError(
                fmt::format("{}: both '{}' and '{}' hold files of lab {}; send one", who, found,
                            item.name, sheet.number));
        found = item.name;
        best = picked;
        for (const Item& other : items)
            if (other.name != item.name && is_of_use(other)) best.ignored.push_back(other.name);
    }
    return best;
}

[[noreturn]] void nothing_found(const std::vector<Item>& items, const std::string& who,
                                const LabSheet& sheet) {
    std::string files;
    for (const std::string& file : sheet.files()) files += (files.empty() ? "" : ", ") + file;
    throw SubmissionError(fmt::format("{}: {}; lab {}'s files are {}", who,
                                      std::none_of(items.begin(), items.end(), is_of_use)
                                          ? "nothing was sent"
                                          : "no file is of the lab",
                                      sheet.number, files));
}

// Where a submission is put together before it gets its name.
fs::path part_of(const fs::path& into) {
    return into.parent_path() / ("." + into.filename().string() + ".part");
}

} // namespace

SentFiles read_items(const std::vector<Item>& items, const std::string& who, const LabSheet& sheet,
                     const fs::path& scratch, const UnpackLimits& limits) {
    const Workplace work(scratch);
    Picked picked = pick_files(items, sheet);
    if (picked.files.empty()) picked = pick_from_archives(items, who, sheet, work, limits);
    if (picked.files.empty()) nothing_found(items, who, sheet);
    SentFiles sent;
    sent.submission.missing = picked.missing;
    sent.submission.ignored = picked.ignored;
    Sha256 hash;
    for (const auto& [file, item] : picked.files) {
        const std::string text =
            source_text(read_sent_file(item.path, item.name, limits.source), item.name);
        hash.add(fmt::format("{} {}\n", text.size(), file));
        hash.add(text);
        sent.submission.files.push_back(file);
        sent.texts.push_back(text);
    }
    sent.submission.hash = hash.hex();
    return sent;
}

Submission write_submission(SentFiles sent, const fs::path& into) {
    if (fs::exists(fs::symlink_status(into)))
        throw FileError(
            fmt::format("'{}' is there already: remove it, or name another folder", into.string()),
            ExitCode::bad_usage);
    const Workplace work(part_of(into));
    for (std::size_t i = 0; i < sent.texts.size(); ++i) {
        const fs::path file = work / "files" / sent.submission.files[i];
        fs::create_directories(file.parent_path());
        write_file(file.string(), sent.texts[i]);
    }
    fs::rename(work / "files", into);
    sent.submission.folder = into;
    return sent.submission;
}

Submission unpack_submission(const fs::path& from, const LabSheet& sheet, const fs::path& into,
                             const UnpackLimits& limits) {
    if (!fs::exists(from))
        throw SubmissionError(
            fmt::format("there is no submission '{}': check the name", from.string()));
    const auto unpack = [&](const std::vector<Item>& items) {
        return write_submission(read_items(items, from.string(), sheet, part_of(into), limits),
                                into);
    };
    if (fs::is_directory(from)) return unpack(items_below(from, limits));
    if (!fs::is_regular_file(from))
        throw SubmissionError(
            fmt::format("the submission '{}' is neither a folder nor a file: name "
                        "one of these",
                        from.string()));
    Item item;
    item.name = from.filename().string();
    item.path = from;
    item.size = fs::file_size(from);
    return unpack({item});
}

} // namespace raylab
