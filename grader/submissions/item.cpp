#include "grader/submissions/item.h"

#include "common/cli/files.h"
#include "grader/results/text.h"
#include "grader/submissions/submission_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

bool has_control(std::string_view name) {
    return std::any_of(name.begin(), name.end(),
                       [](unsigned char c) { return c < 0x20 || c == 0x7F; });
}

// "/x", "C:/x"
bool is_absolute(std::string_view name) {
    return name.starts_with('/') || (name.size() > 2 && name[1] == ':' && name[2] == '/');
}

std::vector<std::string> split(std::string_view name) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string part(name.substr(begin, end - begin));
        if (!part.empty() && part != ".") parts.push_back(part);
        begin = end + 1;
    }
    return parts;
}

std::string why_hostile(std::string_view name, const std::vector<std::string>& parts,
                        const UnpackLimits& limits) {
    if (parts.empty()) return "it is empty";
    if (has_control(name)) return "it holds control characters";
    if (is_absolute(name)) return "it is absolute";
    if (std::find(parts.begin(), parts.end(), "..") != parts.end()) return "it leads out by '..'";
    if (name.size() > limits.name) return fmt::format("it has more than {} bytes", limits.name);
    if (static_cast<int>(parts.size()) > limits.depth)
        return fmt::format("it lies more than {} folders deep", limits.depth);
    return "";
}

Item::Kind kind_of(const fs::directory_entry& entry) {
    const fs::file_status status = entry.symlink_status();
    if (fs::is_symlink(status)) return Item::Kind::link;
    return fs::is_regular_file(status) ? Item::Kind::file : Item::Kind::special;
}

} // namespace

Item item_named(std::string_view raw, const UnpackLimits& limits) {
    std::string name(raw);
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::vector<std::string> parts = split(name);
    Item item;
    item.why = why_hostile(name, parts, limits);
    if (item.why.empty()) {
        item.name = fmt::format("{}", fmt::join(parts, "/"));
        return item;
    }
    item.kind = Item::Kind::hostile;
    item.name = shortened(clean_utf8(name), 200);
    std::replace(item.name.begin(), item.name.end(), '\n', ' ');
    return item;
}

bool is_junk(const std::string& name) {
    static const std::vector<std::string> left_behind = {
        "__MACOSX", ".DS_Store", "Thumbs.db", "desktop.ini", "__pycache__", ".git",
        ".vscode",  ".idea",     ".cache",    "build",       "third_party"};
    for (const std::string& part : split(name))
        if (part.starts_with("._") ||
            std::find(left_behind.begin(), left_behind.end(), part) != left_behind.end())
            return true;
    return false;
}

bool is_archive_name(const std::string& name) {
    const std::string ending = ending_of(name);
    static const std::vector<std::string> endings = {".zip", ".tar", ".tgz", ".tbz2", ".txz",
                                                     ".gz",  ".bz2", ".xz",  ".zst"};
    if (std::find(endings.begin(), endings.end(), ending) == endings.end()) return false;
    const bool is_packed =
        ending == ".gz" || ending == ".bz2" || ending == ".xz" || ending == ".zst";
    return !is_packed || ending_of(fs::path(name).stem()) == ".tar";
}

std::vector<Item> items_below(const fs::path& folder, const UnpackLimits& limits) {
    std::vector<Item> items;
    for (fs::recursive_directory_iterator entry(folder), end; entry != end; ++entry) {
        if (items.size() >= limits.entries)
            throw SubmissionError(fmt::format("'{}' has more than {} files: send only the lab's",
                                              folder.string(), limits.entries));
        const bool is_folder = entry->is_directory() && !entry->is_symlink();
        const std::string raw = entry->path().lexically_relative(folder).string();
        if (is_folder && (is_junk(raw) || entry.depth() >= limits.depth))
            entry.disable_recursion_pending();
        if (is_folder && entry.depth() > 1) continue;
        Item item = item_named(raw, limits);
        if (item.kind != Item::Kind::hostile) {
            item.kind = is_folder ? Item::Kind::folder : kind_of(*entry);
            item.path = entry->path();
            if (item.kind == Item::Kind::file) item.size = entry->file_size();
        }
        items.push_back(item);
    }
    std::sort(items.begin(), items.end(),
              [](const Item& a, const Item& b) { return a.name < b.name; });
    return items;
}

} // namespace raylab
