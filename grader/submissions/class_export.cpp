#include "grader/submissions/class_export.h"

#include "common/cli/files.h"
#include "grader/results/text.h"
#include "grader/submissions/archive.h"
#include "grader/submissions/gradescope_metadata.h"
#include "grader/submissions/pick.h"
#include "grader/submissions/source_text.h"
#include "grader/submissions/submission_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr const char* metadata_name = "submission_metadata.yml";

std::string first_part(const std::string& name) { return name.substr(0, name.find('/')); }
std::string rest_of(const std::string& name) {
    const std::size_t slash = name.find('/');
    return slash == name.npos ? "" : name.substr(slash + 1);
}

// Entries by what the platform calls them, in the order in which they were first met.
class Entries {
  public:
    ClassEntry& of(const std::string& key, const Student& student) {
        const auto [at, fresh] = places_.try_emplace(key, entries_.size());
        if (fresh) {
            entries_.push_back({});
            entries_.back().id = fresh_id(key);
            entries_.back().students = {student};
        }
        return entries_[at->second];
    }
    bool has(const std::string& key) const { return places_.count(key) > 0; }
    std::vector<ClassEntry> take() { return std::move(entries_); }

  private:
    // Letters, digits, '.', '_' and '-' alone, since it becomes the name of a folder.
    std::string fresh_id(const std::string& key) {
        std::string id;
        for (const char c : shortened(key, 80)) {
            const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                               (c >= '0' && c <= '9') || c == '_' || c == '-' ||
                               (c == '.' && !id.empty());
            id += plain ? c : '_';
        }
        const std::string base = id;
        for (int i = 2; !ids_.insert(id).second; ++i) id = fmt::format("{}-{}", base, i);
        return id;
    }

    std::vector<ClassEntry> entries_;
    std::map<std::string, std::size_t> places_;
    std::set<std::string> ids_;
};

void add(ClassEntry& entry, Item item, const std::string& name) {
    item.name = name;
    entry.items.push_back(std::move(item));
}

// Without the one folder that all items lie in, if there is one.
std::optional<std::vector<Item>> without_shared_folder(const std::vector<Item>& items) {
    std::optional<std::string> folder;
    for (const Item& item : items) {
        if (is_junk(item.name) || item.kind == Item::Kind::hostile) continue;
        if (item.kind != Item::Kind::folder && rest_of(item.name).empty()) return std::nullopt;
        if (folder && *folder != first_part(item.name)) return std::nullopt;
        folder = first_part(item.name);
    }
    if (!folder) return std::nullopt;
    std::vector<Item> inner;
    for (Item item : items) {
        if (item.kind != Item::Kind::hostile) item.name = rest_of(item.name);
        if (!item.name.empty()) inner.push_back(item);
    }
    return inner;
}

std::optional<ClassExport> gradescope(const std::vector<Item>& items, const std::string& metadata) {
    const bool found = std::any_of(items.begin(), items.end(),
                                   [](const Item& item) { return item.name == metadata_name; });
    if (!found) return std::nullopt;
    ClassExport all;
    all.layout = "Gradescope";
    Entries entries;
    for (const auto& [folder, students] : read_gradescope_metadata(metadata)) {
        ClassEntry& entry = entries.of(folder, {folder, "", ""});
        if (!students.empty()) entry.students = students;
    }
    for (const Item& item : items) {
        const std::string folder = first_part(item.name), name = rest_of(item.name);
        if (folder.starts_with("submission_") &&
            (!name.empty() || item.kind == Item::Kind::folder)) {
            ClassEntry& entry = entries.of(folder, {folder, "", ""});
            if (!name.empty()) add(entry, item, name);
        } else if (item.name != metadata_name && is_of_use(item)) {
            all.unused.push_back(item.name);
        }
    }
    all.entries = entries.take();
    return all;
}

std::optional<ClassExport> moodle(const std::vector<Item>& items) {
    static const std::regex called(R"((.*)_([0-9]+)_assignsubmission_(file|onlinetext)_?(.*))");
    ClassExport all;
    all.layout = "Moodle";
    Entries entries;
    for (const Item& item : items) {
        const std::string first = first_part(item.name);
        std::smatch match;
        if (!std::regex_match(first, match, called)) {
            if (is_of_use(item)) all.unused.push_back(item.name);
            continue;
        }
        ClassEntry& entry = entries.of(match[2], {match[2], match[1], ""});
        const std::string inner = rest_of(item.name);
        const std::string name = inner.empty() ? match[4].str() : inner;
        if (!name.empty() && item.kind != Item::Kind::folder) add(entry, item, name);
    }
    all.entries = entries.take();
    if (all.entries.empty()) return std::nullopt;
    return all;
}

// Canvas calls the second upload of path.h path-1.h: the latest counts.
void keep_latest(std::vector<Item>& items, int& tries) {
    static const std::regex numbered(R"((.+)-([0-9]{1,4})((\.[^.]+)+))");
    std::map<std::string, std::pair<int, Item>> latest;
    for (const Item& item : items) {
        std::smatch match;
        const bool again = std::regex_match(item.name, match, numbered);
        const std::string name = again ? match[1].str() + match[3].str() : item.name;
        const int number = again ? std::stoi(match[2]) : 0;
        tries = std::max(tries, number + 1);
        const auto at = latest.find(name);
        if (at != latest.end() && at->second.first > number) continue;
        Item named = item;
        named.name = name;
        latest[name] = {number, named};
    }
    items.clear();
    for (const auto& [name, item] : latest) items.push_back(item.second);
}

std::optional<ClassExport> canvas(const std::vector<Item>& items) {
    static const std::regex called(R"(([^_]+)_(LATE_)?([0-9]+)_([0-9]+)_(.+))");
    ClassExport all;
    all.layout = "Canvas";
    Entries entries;
    std::size_t matched = 0;
    for (const Item& item : items) {
        std::smatch match;
        if (item.name.find('/') == item.name.npos && item.kind != Item::Kind::folder &&
            std::regex_match(item.name, match, called)) {
            ClassEntry& entry = entries.of(match[3], {match[3], match[1], ""});
            entry.late = entry.late || match[2].matched;
            add(entry, item, match[5]);
            ++matched;
        } else if (is_of_use(item)) {
            all.unused.push_back(item.name);
        }
    }
    if (matched == 0 || matched < all.unused.size()) return std::nullopt;
    all.entries = entries.take();
    for (ClassEntry& entry : all.entries) keep_latest(entry.items, entry.tries);
    return all;
}

// What all names begin with, up to a '-'.
std::string shared_prefix(const std::set<std::string>& names) {
    std::string prefix = *names.begin();
    for (const std::string& name : names)
        prefix.resize(static_cast<std::size_t>(
            std::mismatch(prefix.begin(), prefix.end(), name.begin(), name.end()).first -
            prefix.begin()));
    const std::size_t dash = prefix.rfind('-');
    return dash == prefix.npos ? "" : prefix.substr(0, dash + 1);
}

std::optional<ClassExport> classroom50(const std::vector<Item>& items) {
    std::set<std::string> folders;
    bool is_download = false;
    for (const Item& item : items) {
        const std::string inner = rest_of(item.name);
        is_download = is_download || item.name == "scores.csv" || inner == "result.json";
        if (item.kind == Item::Kind::hostile || is_junk(item.name)) continue;
        if (!inner.empty() || item.kind == Item::Kind::folder)
            folders.insert(first_part(item.name));
    }
    if (!is_download || folders.size() < 2) return std::nullopt;
    const std::string prefix = shared_prefix(folders);
    if (prefix.empty()) return std::nullopt;
    ClassExport all;
    all.layout = "Classroom 50";
    Entries entries;
    for (const Item& item : items) {
        const std::string folder = first_part(item.name), inner = rest_of(item.name);
        if (inner.empty() && item.kind != Item::Kind::folder) {
            if (item.name != "scores.csv" && is_of_use(item)) all.unused.push_back(item.name);
            continue;
        }
        const std::string login =
            folder.size() > prefix.size() ? folder.substr(prefix.size()) : folder;
        if (item.kind == Item::Kind::hostile && !entries.has(login)) {
            all.unused.push_back(item.name);
            continue;
        }
        ClassEntry& entry = entries.of(login, {login, login, ""});
        if (!inner.empty()) add(entry, item, inner);
    }
    all.entries = entries.take();
    return all;
}

ClassExport plain(const std::vector<Item>& items) {
    ClassExport all;
    all.layout = "a folder or an archive a student";
    Entries entries;
    for (const Item& item : items) {
        if (is_junk(first_part(item.name))) continue;
        std::string key = first_part(item.name);
        const std::string inner = rest_of(item.name);
        const bool is_packed = inner.empty() && is_archive_name(key);
        if (inner.empty() && item.kind != Item::Kind::folder && !is_packed) {
            all.unused.push_back(item.name);
            continue;
        }
        if (is_packed) key = fs::path(key).stem().string();
        if (is_packed && key.ends_with(".tar")) key.resize(key.size() - 4);
        if (item.kind == Item::Kind::hostile && !entries.has(key)) {
            all.unused.push_back(item.name);
            continue;
        }
        ClassEntry& entry = entries.of(key, {key, key, ""});
        if (!inner.empty() || is_packed) add(entry, item, inner.empty() ? item.name : inner);
    }
    all.entries = entries.take();
    return all;
}

// Whether a file of a class's archive may be needed. Platforms put names before and numbers behind
// the students' own: "lovelaceada_123_456_path-1.h".
bool is_kept(const Item& item, const LabSheet& sheet) {
    if (item.size > UnpackLimits().taken) return false;
    if (is_archive_name(item.name) || item.name.ends_with(metadata_name)) return true;
    static const std::regex number(R"(-[0-9]{1,4}(\.[^.]+)$)");
    const std::string name =
        std::regex_replace(fs::path(item.name).filename().string(), number, "$1");
    for (const std::string& file : sheet.files()) {
        const std::string last = fs::path(file).filename().string();
        if (name == last || name.ends_with("_" + last)) return true;
    }
    return false;
}

} // namespace

ClassExport group_class(std::vector<Item> items, const std::string& metadata, bool packed) {
    // A hostile name makes nobody a student; it belongs to one who is there by another file.
    std::stable_partition(items.begin(), items.end(),
                          [](const Item& item) { return item.kind != Item::Kind::hostile; });
    const auto of_platform = [&metadata](const std::vector<Item>& all) {
        std::optional<ClassExport> found = gradescope(all, metadata);
        if (!found) found = moodle(all);
        if (!found) found = canvas(all);
        if (!found) found = classroom50(all);
        return found;
    };
    if (const auto found = of_platform(items)) return *found;
    const std::optional<std::vector<Item>> inner = without_shared_folder(items);
    if (!inner) return plain(items);
    if (const auto found = of_platform(*inner)) return *found;
    return plain(packed ? *inner : items);
}

ClassExport read_class(const fs::path& submissions, const LabSheet& sheet,
                       const fs::path& scratch) {
    if (!fs::exists(submissions))
        throw SubmissionError(
            fmt::format("there are no submissions '{}': check the name", submissions.string()));
    const bool packed = !fs::is_directory(submissions);
    const std::vector<Item> items =
        packed
            ? unpacked_items(submissions, submissions.filename().string(), scratch, class_limits(),
                             [&](const Item& item) { return is_kept(item, sheet); })
            : items_below(submissions, class_limits());
    std::string metadata;
    for (const Item& item : items)
        if (item.kind == Item::Kind::file && !item.path.empty() &&
            (item.name == metadata_name ||
             (rest_of(item.name) == metadata_name && metadata.empty())))
            metadata = read_sent_file(item.path, item.name, 64u << 20);
    ClassExport all = group_class(items, metadata, packed);
    if (all.entries.empty())
        throw SubmissionError(
            fmt::format("'{}' holds no submission: name the folder or the archive "
                        "that the platform's export is",
                        submissions.string()));
    return all;
}

} // namespace raylab
