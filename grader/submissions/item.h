// One file that a student has sent, in a folder or in an archive, before anything is done with it.
#pragma once

#include "grader/submissions/limits.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

struct Item {
    enum class Kind {
        file,
        folder,  // of the uppermost two levels only: it may be a student's, and empty
        link,    // symbolic or hard
        special, // a device, a pipe, a socket
        hostile, // its name leads elsewhere; `name` is a printable form of it
    };
    std::string name; // relative, '/' between folders, none of them "." or ".."
    Kind kind = Kind::file;
    std::uint64_t size = 0;
    std::filesystem::path path; // where its bytes lie; empty: not taken out of its archive
    std::string why;            // of hostile ones: half a sentence
};

// A name as it stands in an archive or a folder: '\' becomes '/', "." and "" fall away. Names that
// lead out of the folder, are absolute, hold control characters, are too long or too deep become
// hostile items.
Item item_named(std::string_view raw, const UnpackLimits& limits);

// What systems and tools leave in folders: "__MACOSX/x", ".DS_Store", ".git/x", "build/x", ...
bool is_junk(const std::string& name);

inline bool is_of_use(const Item& item) {
    return item.kind != Item::Kind::folder && !is_junk(item.name);
}

// Whether a name ends as an archive does: ".zip", ".tar", ".tar.gz", ".tgz", ...
bool is_archive_name(const std::string& name);

// All files below a folder, and the folders of the uppermost two levels, sorted by name; links are
// not followed. Throws SubmissionError if there are too many.
std::vector<Item> items_below(const std::filesystem::path& folder, const UnpackLimits& limits);

} // namespace raylab
