#include "grader/class/journal.h"

#include "common/cli/files.h"
#include "grader/class/journal_text.h"
#include "grader/results/marks_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

constexpr std::int64_t application = 0x7261796C; // "rayl": SQLite keeps it in the file's head

const char* name_of(Set set) { return set == Set::live ? "live" : "staged"; }

// state: 0 done, 1 waits, 2 is being graded.
constexpr const char* schema = R"sql(
CREATE TABLE about (lab TEXT NOT NULL, runs INTEGER NOT NULL);
CREATE TABLE submissions (
    id TEXT PRIMARY KEY, students TEXT NOT NULL, late INTEGER NOT NULL, tries INTEGER NOT NULL,
    hash TEXT NOT NULL, refused TEXT NOT NULL, missing TEXT NOT NULL, ignored TEXT NOT NULL);
CREATE TABLE graded (
    part TEXT NOT NULL, id TEXT NOT NULL, state INTEGER NOT NULL, run TEXT NOT NULL DEFAULT '',
    marks TEXT NOT NULL DEFAULT '', trouble TEXT NOT NULL DEFAULT '', seconds REAL NOT NULL DEFAULT 0,
    at TEXT NOT NULL DEFAULT '', next_run TEXT NOT NULL DEFAULT '', PRIMARY KEY (part, id));
)sql";

Graded graded_of(const Statement& row, int column) {
    Graded graded;
    graded.run = row.text(column);
    if (const std::string marks = row.text(column + 1); !marks.empty())
        graded.marks = read_marks_json(marks, "journal");
    graded.trouble = row.text(column + 2);
    graded.seconds = row.real(column + 3);
    graded.when = row.text(column + 4);
    return graded;
}

bool has_verdict(const Graded& graded, MarkVerdict verdict) {
    if (graded.verdict() == verdict) return true;
    if (!graded.marks) return false;
    return std::any_of(graded.marks->tasks.begin(), graded.marks->tasks.end(),
                       [verdict](const Mark& mark) { return mark.verdict == verdict; });
}

} // namespace

MarkVerdict Graded::verdict() const {
    if (!trouble.empty()) return MarkVerdict::internal;
    return marks ? overall(*marks) : MarkVerdict::not_run;
}

Journal::Journal(const std::filesystem::path& folder, const std::string& lab)
    : file_(folder / "journal.sqlite"), database_(file_) {
    if (database_.number("SELECT count(*) FROM sqlite_master") == 0 &&
        database_.number("PRAGMA user_version") == 0)
        make(lab);
    expect_own();
    Statement about = database_.prepare("SELECT lab FROM about");
    if (about.step() && about.text(0) != lab)
        throw FileError(
            fmt::format("'{}' has the marks of lab {}, not of {}: name another folder with "
                        "-o",
                        folder.string(), about.text(0), lab),
            ExitCode::bad_usage);
    database_.run("UPDATE graded SET state = 1 WHERE state = 2");
}

void Journal::make(const std::string& lab) const {
    Transaction all(database_);
    database_.run(schema);
    database_.prepare("INSERT INTO about VALUES (?, 0)").bind(1, lab).done();
    database_.run(fmt::format("PRAGMA application_id = {}", application).c_str());
    database_.run(fmt::format("PRAGMA user_version = {}", journal_version).c_str());
    all.commit();
}

void Journal::expect_own() const {
    if (database_.number("PRAGMA application_id") != application)
        throw FileError(fmt::format("'{}' is no journal of raylab: name another folder with -o",
                                    file_.string()),
                        ExitCode::bad_usage);
    if (const auto version = database_.number("PRAGMA user_version"); version != journal_version)
        throw FileError(
            fmt::format("the journal '{}' has version {}, and this raylab keeps version {}: "
                        "use the raylab that made it, or name another folder with -o",
                        file_.string(), version, journal_version),
            ExitCode::bad_usage);
}

void Journal::enter(const std::vector<JournalRow>& rows) {
    const std::lock_guard lock(mutex_);
    Transaction all(database_);
    for (const JournalRow& row : rows) enter_one(row);
    all.commit();
}

void Journal::enter_one(const JournalRow& row) {
    Statement known = database_.prepare("SELECT hash, refused FROM submissions WHERE id = ?");
    const bool is_known = known.bind(1, row.id).step();
    const bool same = is_known && known.text(0) == row.hash && known.text(1) == row.refused;
    database_.prepare("REPLACE INTO submissions VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(1, row.id)
        .bind(2, text_of(row.students))
        .bind(3, std::int64_t(row.late))
        .bind(4, std::int64_t(row.tries))
        .bind(5, row.hash)
        .bind(6, row.refused)
        .bind(7, text_of(row.missing))
        .bind(8, text_of(row.ignored))
        .done();
    // What was sent anew is graded anew, in a stage too; until then its old marks stand.
    if (!is_known)
        database_.prepare("INSERT INTO graded (part, id, state) VALUES ('live', ?, ?)")
            .bind(1, row.id)
            .bind(2, std::int64_t(row.refused.empty()))
            .done();
    else if (!same && row.refused.empty())
        database_.prepare("UPDATE graded SET state = 1 WHERE id = ?").bind(1, row.id).done();
    else if (!same) {
        database_.prepare("DELETE FROM graded WHERE part = 'staged' AND id = ?")
            .bind(1, row.id)
            .done();
        database_
            .prepare("UPDATE graded SET state = 0, marks = '', run = '', trouble = '' WHERE id = ?")
            .bind(1, row.id)
            .done();
    }
}

int Journal::wait_again(MarkVerdict verdict) {
    std::vector<std::string> ids;
    each(Set::live, [&](const JournalRow& row) {
        if (row.refused.empty() && !row.waits && has_verdict(row.graded, verdict))
            ids.push_back(row.id);
    });
    const std::lock_guard lock(mutex_);
    Transaction all(database_);
    for (const std::string& id : ids)
        database_.prepare("UPDATE graded SET state = 1 WHERE part = 'live' AND id = ?")
            .bind(1, id)
            .done();
    all.commit();
    return static_cast<int>(ids.size());
}

int Journal::begin_stage(std::optional<MarkVerdict> verdict) {
    if (const int there = staged(); there > 0) return there;
    std::vector<std::string> ids;
    each(Set::live, [&](const JournalRow& row) {
        if (row.refused.empty() && (!verdict || has_verdict(row.graded, *verdict)))
            ids.push_back(row.id);
    });
    const std::lock_guard lock(mutex_);
    Transaction all(database_);
    for (const std::string& id : ids)
        database_.prepare("INSERT INTO graded (part, id, state) VALUES ('staged', ?, 1)")
            .bind(1, id)
            .done();
    all.commit();
    return static_cast<int>(ids.size());
}

int Journal::staged() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(database_.number("SELECT count(*) FROM graded WHERE part = 'staged'"));
}

void Journal::apply_stage() {
    if (const int left = waiting(Set::staged); left > 0)
        throw FileError(
            fmt::format("{} submissions of the stage are not graded yet: finish it with "
                        "--stage, or drop it with --drop",
                        left),
            ExitCode::bad_usage);
    const std::lock_guard lock(mutex_);
    Transaction all(database_);
    // The grader's own trouble changes no mark.
    database_.run("DELETE FROM graded WHERE part = 'staged' AND trouble <> ''");
    database_.run(
        "DELETE FROM graded WHERE part = 'live' AND id IN (SELECT id FROM graded WHERE part = "
        "'staged')");
    database_.run("UPDATE graded SET part = 'live' WHERE part = 'staged'");
    all.commit();
}

void Journal::drop_stage() {
    const std::lock_guard lock(mutex_);
    database_.run("DELETE FROM graded WHERE part = 'staged'");
}

std::optional<Journal::Work> Journal::take(Set set) {
    const std::lock_guard lock(mutex_);
    Transaction all(database_);
    Statement next = database_.prepare(
        "SELECT s.id, s.hash FROM graded g JOIN submissions s ON s.id = g.id WHERE g.part = ? AND "
        "g.state = 1 AND s.refused = '' ORDER BY s.id LIMIT 1");
    if (!next.bind(1, name_of(set)).step()) return std::nullopt;
    // A number of its own for each attempt: what a killed one left is never taken for this one's.
    database_.run("UPDATE about SET runs = runs + 1");
    const Work work = {
        next.text(0), next.text(1),
        fmt::format("{}.{}", next.text(0), database_.number("SELECT runs FROM about"))};
    database_.prepare("UPDATE graded SET state = 2, next_run = ? WHERE part = ? AND id = ?")
        .bind(1, work.run)
        .bind(2, name_of(set))
        .bind(3, work.id)
        .done();
    next = database_.prepare("SELECT 1"); // a statement that stands on a row keeps the file locked
    all.commit();
    return work;
}

void Journal::finish(Set set, const Work& work, const Graded& graded) {
    const std::lock_guard lock(mutex_);
    Transaction all(database_);
    // The grader's own trouble leaves the marks that were there.
    if (!graded.trouble.empty())
        database_
            .prepare("UPDATE graded SET state = 0, trouble = ?, seconds = ?, at = ? WHERE part = ? "
                     "AND id = ?")
            .bind(1, graded.trouble)
            .bind(2, graded.seconds)
            .bind(3, graded.when)
            .bind(4, name_of(set))
            .bind(5, work.id)
            .done();
    else
        database_
            .prepare("UPDATE graded SET state = 0, trouble = '', run = ?, marks = ?, seconds = ?, "
                     "at = ? "
                     "WHERE part = ? AND id = ?")
            .bind(1, work.run)
            .bind(2, marks_json(graded.marks.value()))
            .bind(3, graded.seconds)
            .bind(4, graded.when)
            .bind(5, name_of(set))
            .bind(6, work.id)
            .done();
    all.commit();
}

int Journal::waiting(Set set) const {
    const std::lock_guard lock(mutex_);
    Statement count = database_.prepare("SELECT count(*) FROM graded WHERE part = ? AND state > 0");
    count.bind(1, name_of(set)).step();
    return static_cast<int>(count.integer(0));
}

void Journal::each(Set set, const std::function<void(const JournalRow& row)>& see) const {
    const std::lock_guard lock(mutex_);
    Statement rows = database_.prepare(
        "SELECT s.id, students, late, tries, hash, refused, missing, ignored, run, marks, trouble, "
        "seconds, at, state FROM graded g JOIN submissions s ON s.id = g.id WHERE part = ? ORDER "
        "BY s.id");
    rows.bind(1, name_of(set));
    while (rows.step()) {
        JournalRow row;
        row.id = rows.text(0);
        row.students = students_of(rows.text(1));
        row.late = rows.integer(2) != 0;
        row.tries = static_cast<int>(rows.integer(3));
        row.hash = rows.text(4);
        row.refused = rows.text(5);
        row.missing = words_of(rows.text(6));
        row.ignored = words_of(rows.text(7));
        row.graded = graded_of(rows, 8);
        row.waits = rows.integer(13) != 0;
        see(row);
    }
}

std::optional<Graded> Journal::live(const std::string& id) const {
    const std::lock_guard lock(mutex_);
    Statement row = database_.prepare(
        "SELECT run, marks, trouble, seconds, at FROM graded WHERE part = 'live' AND id = ?");
    if (!row.bind(1, id).step()) return std::nullopt;
    return graded_of(row, 0);
}

std::vector<std::string> Journal::runs() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> names;
    Statement rows = database_.prepare("SELECT run FROM graded WHERE run <> ''");
    while (rows.step()) names.push_back(rows.text(0));
    return names;
}

std::vector<std::string> Journal::hashes() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> names;
    Statement rows = database_.prepare("SELECT DISTINCT hash FROM submissions WHERE hash <> ''");
    while (rows.step()) names.push_back(rows.text(0));
    return names;
}

} // namespace raylab
