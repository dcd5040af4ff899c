#include "grader/class/database.h"

#include "common/cli/files.h"

#include <fmt/format.h>
#include <sqlite3.h>

namespace raylab {

namespace {

[[noreturn]] void fail(sqlite3* database, int status, const std::filesystem::path& file) {
    const auto error = [&file](const std::string& why, ExitCode code) {
        return FileError(fmt::format("the journal '{}': {}", file.string(), why), code);
    };
    switch (status & 0xFF) {
    case SQLITE_FULL:
        throw error(
            "the disk is full: free some space and run the same command again, nothing is lost",
            ExitCode::tool_failed);
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
        throw error(
            "no permission: check the rights of the file and of its folder, or name another "
            "folder with -o",
            ExitCode::bad_usage);
    case SQLITE_IOERR:
        throw error("it cannot be read or written: is the disk full, or is there a limit (`ulimit "
                    "-f`)? Run the "
                    "same command again when there is room, nothing is lost",
                    ExitCode::tool_failed);
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
        throw error("it is damaged, or another program's file: name another folder with -o",
                    ExitCode::bad_usage);
    default:
        throw error(database ? sqlite3_errmsg(database) : sqlite3_errstr(status),
                    ExitCode::tool_failed);
    }
}

} // namespace

Statement::Statement(sqlite3* database, const std::filesystem::path& file, const char* sql)
    : database_(database), file_(file) {
    sqlite3_stmt* statement = nullptr;
    const int status = sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
    if (status != SQLITE_OK) fail(database, status, file);
    statement_.reset(statement, sqlite3_finalize);
}

Statement& Statement::bind(int place, std::string_view text) {
    sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(), SQLITE_TRANSIENT,
                        SQLITE_UTF8);
    return *this;
}

Statement& Statement::bind(int place, std::int64_t number) {
    sqlite3_bind_int64(statement_.get(), place, number);
    return *this;
}

Statement& Statement::bind(int place, double number) {
    sqlite3_bind_double(statement_.get(), place, number);
    return *this;
}

bool Statement::step() {
    const int status = sqlite3_step(statement_.get());
    if (status == SQLITE_ROW) return true;
    if (status != SQLITE_DONE) fail(database_, status, file_);
    return false;
}

void Statement::done() {
    while (step()) {
    }
}

std::string Statement::text(int column) const {
    const void* bytes = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return bytes ? std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size))
                 : "";
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

Database::Database(const std::filesystem::path& file) : file_(file) {
    sqlite3* database = nullptr;
    const int status = sqlite3_open_v2(file.c_str(), &database,
                                       SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    database_.reset(database, sqlite3_close_v2);
    if (status != SQLITE_OK) fail(database, status, file);
    sqlite3_busy_timeout(database, 5000); // another program may look at it meanwhile
    run("PRAGMA synchronous = FULL");
}

Statement Database::prepare(const char* sql) const { return {database_.get(), file_, sql}; }

void Database::run(const char* sql) const {
    const int status = sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
    if (status != SQLITE_OK) fail(database_.get(), status, file_);
}

std::int64_t Database::number(const char* sql) const {
    Statement statement = prepare(sql);
    return statement.step() ? statement.integer(0) : 0;
}

Transaction::Transaction(const Database& database) : database_(database) {
    database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    try {
        if (open_) database_.run("ROLLBACK");
    } catch (const FileError&) { // SQLite has rolled back by itself
    }
}

void Transaction::commit() {
    database_.run("COMMIT");
    open_ = false;
}

} // namespace raylab
