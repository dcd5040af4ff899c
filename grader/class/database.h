// SQLite with errors that are sentences.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace raylab {

// A prepared statement: bind its '?' from 1 on, then step() once a row.
class Statement {
  public:
    Statement(sqlite3* database, const std::filesystem::path& file, const char* sql);

    Statement& bind(int place, std::string_view text);
    Statement& bind(int place, std::int64_t number);
    Statement& bind(int place, double number);
    bool step(); // false: no further row. Throws FileError
    void done(); // step() of a statement without rows

    // Of the row, columns from 0 on.
    std::string text(int column) const;
    std::int64_t integer(int column) const;
    double real(int column) const;

  private:
    std::shared_ptr<sqlite3_stmt> statement_;
    sqlite3* database_;
    std::filesystem::path file_;
};

class Database {
  public:
    // Opens the file, or makes it. Throws FileError: no permission, a full disk, no database.
    explicit Database(const std::filesystem::path& file);

    Statement prepare(const char* sql) const;
    void run(const char* sql) const;            // statements without rows
    std::int64_t number(const char* sql) const; // the first column of the first row

  private:
    std::filesystem::path file_;
    std::shared_ptr<sqlite3> database_;
};

// All or nothing of what is done while it lives: commit(), or else nothing of it.
class Transaction {
  public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    void commit();

  private:
    const Database& database_;
    bool open_ = true;
};

} // namespace raylab
