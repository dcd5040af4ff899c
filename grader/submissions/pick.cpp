#include "grader/submissions/pick.h"

#include "grader/submissions/submission_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <tuple>

namespace raylab {

namespace {

// A folder of the submission that may be the lab's: "", "labs/02_iterative/", "my work/".
struct Root {
    std::map<std::string, const Item*> files; // by their name in the lab's folder
};

// The part of a name before `file`; nothing if the name does not end so.
std::optional<std::string> root_of(const std::string& name, const std::string& file) {
    if (name == file) return "";
    if (!name.ends_with("/" + file)) return std::nullopt;
    return name.substr(0, name.size() - file.size());
}

// "labs/03_wavefront/" when the lab is another: a file there may have the same name.
bool is_of_another_lab(const std::string& root, const std::string& folder) {
    std::string path = "/" + root;
    for (std::size_t at = path.find("/labs/"); at != path.npos; at = path.find("/labs/", at + 1)) {
        const std::size_t begin = at + 6, end = path.find('/', begin);
        if (end != path.npos && path.substr(begin, end - begin) != folder) return true;
    }
    return false;
}

// The greater, the likelier.
std::tuple<int, std::size_t, long> likelihood(const std::string& root, const Root& found,
                                              const std::string& folder) {
    const std::string path = "/" + root;
    const int named = path.ends_with("/labs/" + folder + "/") ? 2
                      : path.ends_with("/" + folder + "/")    ? 1
                                                              : 0;
    return {named, found.files.size(), -std::count(root.begin(), root.end(), '/')};
}

std::map<std::string, Root> roots_in(const std::vector<Item>& items, const LabSheet& sheet) {
    std::map<std::string, Root> roots;
    for (const Item& item : items) {
        if (!is_of_use(item)) continue;
        for (const std::string& file : sheet.files())
            if (const auto root = root_of(item.name, file);
                root && !is_of_another_lab(*root, sheet.folder))
                roots[*root].files[file] = &item;
    }
    return roots;
}

} // namespace

bool could_be_of_lab(const std::string& name, const LabSheet& sheet) {
    const std::vector<std::string> files = sheet.files();
    return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
        const auto root = root_of(name, file);
        return root && !is_of_another_lab(*root, sheet.folder);
    });
}

Picked pick_files(const std::vector<Item>& items, const LabSheet& sheet) {
    for (const Item& item : items)
        if (item.kind == Item::Kind::hostile)
            throw SubmissionError(fmt::format("the name '{}' is not taken: {}; nothing of this "
                                              "submission was used",
                                              item.name, item.why));
    const std::map<std::string, Root> roots = roots_in(items, sheet);
    const Root* best = nullptr;
    std::string name;
    for (const auto& [root, found] : roots) {
        const auto more =
            best ? likelihood(root, found, sheet.folder) <=> likelihood(name, *best, sheet.folder)
                 : std::strong_ordering::greater;
        if (more == 0)
            throw SubmissionError(fmt::format("the folders '{}' and '{}' may both be lab {}'s; "
                                              "send one",
                                              name, root, sheet.number));
        if (more > 0) best = &found, name = root;
    }
    Picked picked;
    std::vector<const Item*> used;
    const std::map<std::string, const Item*> none;
    const std::map<std::string, const Item*>& found = best ? best->files : none;
    for (const std::string& file : sheet.files()) {
        const auto at = found.find(file);
        if (at == found.end()) {
            picked.missing.push_back(file);
        } else if (at->second->kind != Item::Kind::file) {
            const bool is_link = at->second->kind == Item::Kind::link;
            picked.missing.push_back(
                file + (is_link ? " (a link is not followed)" : " (no regular file)"));
        } else {
            picked.files.push_back({file, *at->second});
            used.push_back(at->second);
        }
    }
    for (const Item& item : items)
        if (is_of_use(item) && std::find(used.begin(), used.end(), &item) == used.end())
            picked.ignored.push_back(item.name);
    return picked;
}

} // namespace raylab
