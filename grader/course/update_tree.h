// A mended release comes into a tree in which a student has worked.
//
// Three trees take part: `base` is the release as the student got it, `mended` the new one, `own`
// what the student has made of it.
//
//     own = base                     -> mended         added, replaced, removed
//     own has what base has not      -> own            the student's file
//     mended = base                  -> own            the student's change
//     both changed the file          -> both changes, if they do not touch each other (merged);
//                                       else the student's file stays, and the mended one is
//                                       written beside it as FILE.new (kept)
//
// A file with tasks is the student's in any case: it is never merged.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace raylab {

enum class Fate { added, replaced, removed, merged, kept };

struct FileUpdate {
    std::string file; // relative to the trees
    Fate fate;
    std::string text; // what is to be written: to the file, or beside it if it is kept
};

// What is to be done, in the order of the names; nothing is written. `task_files` are relative to
// the trees. Throws FileError.
std::vector<FileUpdate> plan_update(const std::filesystem::path& base,
                                    const std::filesystem::path& mended,
                                    const std::filesystem::path& own,
                                    const std::set<std::string>& task_files);

// Does it, each file under a temporary name first. Doing it again after an interruption does the
// rest. Throws FileError.
void apply_update(const std::vector<FileUpdate>& updates, const std::filesystem::path& mended,
                  const std::filesystem::path& own);

const char* name(Fate fate); // "added", ...

} // namespace raylab
