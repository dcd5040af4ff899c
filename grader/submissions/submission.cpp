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

// Where a submission is put together before it gets its name; left empty-handed by a kill, it is
// removed by the next attempt.
class Workplace {
  public:
    explicit Workplace(const fs::path& into)
        : folder_(into.parent_path() / ("." + into.filename().string() + ".part")) {
        if (fs::exists(fs::symlink_status(into)))
            throw FileError(fmt::format("'{}' is there already: remove it, or name another folder",
                                        into.string()),
                            ExitCode::bad_usage);
        fs::remove_all(folder_);
        fs::create_directories(files());
    }
    ~Workplace() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    fs::path files() const { return folder_ / "files"; }
    fs::path archive(std::size_t number) const {
        return folder_ / fmt::format("archive{}", number);
    }

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
            pick_files(items_of_archive(item, sheet, work.archive(i), limits), sheet);
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

} // namespace

Submission unpack_items(const std::vector<Item>& items, const std::string& who,
                        const LabSheet& sheet, const fs::path& into, const UnpackLimits& limits) {
    const Workplace work(into);
    Picked picked = pick_files(items, sheet);
    if (picked.files.empty()) picked = pick_from_archives(items, who, sheet, work, limits);
    if (picked.files.empty()) nothing_found(items, who, sheet);
    Submission submission;
    submission.folder = into;
    submission.missing = picked.missing;
    submission.ignored = picked.ignored;
    Sha256 hash;
    for (const auto& [file, item] : picked.files) {
        const std::string text =
            source_text(read_sent_file(item.path, item.name, limits.source), item.name);
        fs::create_directories((work.files() / file).parent_path());
        write_file((work.files() / file).string(), text);
        hash.add(fmt::format("{} {}\n", text.size(), file));
        hash.add(text);
        submission.files.push_back(file);
    }
    submission.hash = hash.hex();
    fs::rename(work.files(), into);
    return submission;
}

Submission unpack_submission(const fs::path& from, const LabSheet& sheet, const fs::path& into,
                             const UnpackLimits& limits) {
    if (!fs::exists(from))
        throw SubmissionError(
            fmt::format("there is no submission '{}': check the name", from.string()));
    if (fs::is_directory(from))
        return unpack_items(items_below(from, limits), from.string(), sheet, into, limits);
    if (!fs::is_regular_file(from))
        throw SubmissionError(
            fmt::format("the submission '{}' is neither a folder nor a file: name "
                        "one of these",
                        from.string()));
    Item item;
    item.name = from.filename().string();
    item.path = from;
    item.size = fs::file_size(from);
    return unpack_items({item}, from.string(), sheet, into, limits);
}

} // namespace raylab
