// What is known of a class: a file of SQLite, journal.sqlite. One transaction says that a
// submission is graded, and nothing else does: whatever is killed, a submission is either graded or
// waits.
//
// A regrade is a stage: the same columns once more, for the submissions that are graded again.
// apply() puts them in the place of the old ones at once, drop() forgets them.
#pragma once

#include "grader/class/database.h"
#include "grader/results/marks.h"
#include "grader/submissions/class_export.h"

#include <functional>
#include <mutex>
#include <optional>

namespace raylab {

constexpr int journal_version = 1;

enum class Set { live, staged };

// What grading a submission has brought.
struct Graded {
    std::string run;            // the folder of its files, below `runs`; empty: it was not graded
    std::optional<Marks> marks; // the last that the grader could say
    std::string trouble;        // the grader's own, at the last attempt: then the marks are older
    double seconds = 0;
    std::string when; // UTC, "2026-11-28T10:00:00Z"

    MarkVerdict verdict() const; // INTERNAL if there is trouble; NOT_RUN if there are no marks
};

struct JournalRow {
    std::string id;
    std::vector<Student> students;
    bool late = false;
    int tries = 0;                             // 0: not known
    std::string hash;                          // of the files that were sent; empty: refused
    std::string refused;                       // why nothing of it could be graded; or empty
    std::vector<std::string> missing, ignored; // files
    Graded graded;
    bool waits = false; // to be graded, for the first time or again
};

class Journal {
  public:
    // Opens or makes the journal of the folder. Throws FileError, for another version and for
    // another lab too. What was being graded when a program was killed waits again.
    Journal(const std::filesystem::path& folder, const std::string& lab);

    // The submissions as they are in the export, all or none: new ones and changed ones wait,
    // others stay as they are. What a row says of grading is not read.
    void enter(const std::vector<JournalRow>& rows);
    // All submissions wait again whose verdict, or a task's, is this one. Returns how many.
    int wait_again(MarkVerdict verdict);

    // Begins a stage for all submissions that were graded, or for those with the verdict; goes on
    // with the one that is there. Returns how many it has.
    int begin_stage(std::optional<MarkVerdict> verdict);
    int staged() const;
    void apply_stage(); // throws FileError if a submission of it still waits
    void drop_stage();

    // Takes a submission that waits, or nothing; any thread may call. `run` is its folder's name.
    struct Work {
        std::string id, hash, run;
    };
    std::optional<Work> take(Set set);
    void finish(Set set, const Work& work, const Graded& graded);
    int waiting(Set set) const;

    // In the order of their ids. Marks of a class may be large: one row at a time is in memory.
    void each(Set set, const std::function<void(const JournalRow& row)>& see) const;
    std::optional<Graded> live(const std::string& id) const;
    std::vector<std::string> runs() const;   // that a submission refers to
    std::vector<std::string> hashes() const; // the same of submissions' files

  private:
    void expect_own() const;
    void make(const std::string& lab) const;
    void enter_one(const JournalRow& row);

    std::filesystem::path file_;
    Database database_;
    mutable std::recursive_mutex mutex_; // each() may ask more
};

} // namespace raylab
