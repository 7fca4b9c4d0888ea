// Statements of SQLite. Private to the server's library.
#pragma once

#include <fmt/format.h>
#include <sqlite3.h>

#include <cstdint>
#include <optional>
#include <string>

#include "server/disk_file.hpp"

namespace pal::server {

/// Throws StoreProblem with what the database says.
[[noreturn]] inline void fail_in(sqlite3* database) {
  refuse(Refusal::Why::failed, fmt::format("the history: {}", sqlite3_errmsg(database)),
         "look at the disk of the cell's computer");
}

/// A statement that is used again and again. Functions throw StoreProblem.
class Query {
 public:
  Query(sqlite3* database, const char* text) : database_(database) {
    if (sqlite3_prepare_v2(database, text, -1, &statement_, nullptr) != SQLITE_OK) fail_in(database);
  }
  ~Query() { sqlite3_finalize(statement_); }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  Query& put(int at, std::int64_t value) {
    sqlite3_bind_int64(statement_, at, value);
    return *this;
  }
  Query& put(int at, const std::string& text) {
    sqlite3_bind_text(statement_, at, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
    return *this;
  }
  Query& put_bytes(int at, const std::string& bytes) {
    sqlite3_bind_blob(statement_, at, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
    return *this;
  }
  Query& put(int at, std::optional<std::int64_t> value) {
    if (value) return put(at, *value);
    sqlite3_bind_null(statement_, at);
    return *this;
  }
  Query& put(int at, const std::optional<std::string>& text) {
    if (text) return put(at, *text);
    sqlite3_bind_null(statement_, at);
    return *this;
  }
  /// Whether there is a further row.
  bool next() {
    const int result = sqlite3_step(statement_);
    if (result == SQLITE_ROW) return true;
    if (result != SQLITE_DONE) fail_in(database_);
    return false;
  }
  void run() {
    while (next()) {
    }
  }
  std::int64_t number(int at) const { return sqlite3_column_int64(statement_, at); }
  bool empty(int at) const { return sqlite3_column_type(statement_, at) == SQLITE_NULL; }
  /// Text, or bytes.
  std::string text(int at) const {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, at));
    return bytes == nullptr
               ? std::string()
               : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, at)));
  }

 private:
  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
};

inline void execute(sqlite3* database, const char* text) {
  if (sqlite3_exec(database, text, nullptr, nullptr, nullptr) != SQLITE_OK) fail_in(database);
}

inline std::int64_t pragma(sqlite3* database, const char* text) {
  Query query(database, text);
  query.next();
  return query.number(0);
}

/// What the database takes, without pages that are free.
inline std::int64_t bytes_of(sqlite3* database) {
  return (pragma(database, "PRAGMA page_count") - pragma(database, "PRAGMA freelist_count")) *
         pragma(database, "PRAGMA page_size");
}

/// Closes a database when it goes.
class Database {
 public:
  /// Opens FILE; empty: a file of its own that goes with it. Throws StoreProblem.
  explicit Database(const std::string& file) {
    constexpr int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
    if (sqlite3_open_v2(file.c_str(), &database_, flags, nullptr) == SQLITE_OK) return;
    const std::string why = sqlite3_errmsg(database_);
    sqlite3_close(database_);
    refuse(Refusal::Why::failed, fmt::format("{}: {}", file, why), "name a folder that can be written");
  }
  ~Database() { sqlite3_close(database_); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  operator sqlite3*() const { return database_; }  // NOLINT(google-explicit-constructor)

 private:
  sqlite3* database_ = nullptr;
};

}  // namespace pal::server
