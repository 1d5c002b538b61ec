// SPDX-License-Identifier: BSD-3-Clause
// One connection to an SQLite file: statements, bound values, transactions. No SQLite type is visible outside store/.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "study/error.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace rouleau::campaign {

/// The file as a whole could not be read or written, so the next statement meets the same. What is wrong with one
/// statement or one row is a plain Error.
class DatabaseError : public Error {
 public:
  DatabaseError(Exit code, const std::string& message, bool waiting_mends)
      : Error(code, message), waiting_mends_(waiting_mends) {}
  /// True: locked by others, no room, no rights, a failing medium; the same may work later. False: damaged, or gone.
  [[nodiscard]] bool waiting_mends() const { return waiting_mends_; }

 private:
  bool waiting_mends_;
};

/// A value of a column: NULL, INTEGER, REAL or TEXT.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

/// A whole answer, read to its end: no lock is held while it is used.
struct Rows {
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

class Database;

/// A prepared statement. Parameters and columns count from 1 and from 0, as in SQLite.
class Statement {
 public:
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  Statement(Statement&&) noexcept;
  ~Statement();

  /// Binds the parameters in order. A double that is not finite is a broken promise of the caller (SQLite would store
  /// NULL).
  template <class... Args>
  Statement& bind(const Args&... args) {
    int index = 0;
    (bind_one(++index, args), ...);
    return *this;
  }
  Statement& bind_values(std::span<const Value> values);

  bool step();  ///< true while there is a row
  void run();   ///< steps to the end and resets: for statements without an answer
  void reset();

  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] Value value(int column) const;
  [[nodiscard]] std::optional<double> optional_real(int column) const;
  [[nodiscard]] std::optional<std::int64_t> optional_integer(int column) const;
  [[nodiscard]] int columns() const;
  [[nodiscard]] std::string column_name(int column) const;

 private:
  friend class Database;
  Statement(sqlite3* connection, sqlite3_stmt* statement) : connection_(connection), statement_(statement) {}
  void bind_one(int index, std::nullptr_t);
  void bind_one(int index, std::int64_t value);
  void bind_one(int index, int value) { bind_one(index, static_cast<std::int64_t>(value)); }
  void bind_one(int index, bool value) { bind_one(index, static_cast<std::int64_t>(value)); }
  void bind_one(int index, double value);
  void bind_one(int index, std::string_view value);
  void bind_one(int index, const std::string& value) { bind_one(index, std::string_view(value)); }
  void bind_one(int index, const char* value) { bind_one(index, std::string_view(value)); }
  void bind_one(int index, const Value& value);
  template <class T>
  void bind_one(int index, const std::optional<T>& value) {
    if (value)
      bind_one(index, *value);
    else
      bind_one(index, nullptr);
  }

  sqlite3* connection_ = nullptr;
  sqlite3_stmt* statement_ = nullptr;
};

enum class Access {
  read_only,   ///< never changes the file, waits at most one second for a writer, in all its statements together
  read_write,  ///< waits up to ten seconds
  create,      ///< as read_write; the file must not exist
};

/// A connection. Never carried over fork().
class Database {
 public:
  /// throws  Error when the file cannot be opened, is not an SQLite file, or (create) exists
  Database(const std::filesystem::path& file, Access access);
  Database(Database&&) noexcept = default;
  Database& operator=(Database&&) noexcept = default;

  [[nodiscard]] Statement prepare(std::string_view sql) const;
  /// Runs statements without parameters and without an answer.
  void execute(const std::string& sql) const;
  /// Prepares, binds, reads all.
  [[nodiscard]] Rows select(std::string_view sql, std::span<const Value> values = {}) const;
  [[nodiscard]] std::int64_t select_integer(std::string_view sql) const;
  [[nodiscard]] int changes() const;  ///< rows that the last statement changed
  [[nodiscard]] bool in_transaction() const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  class Patience;
  struct Close {
    void operator()(sqlite3* connection) const;
  };
  /// A writer with a patience waits no longer than that; one without, ten seconds.
  Database(const std::filesystem::path& file, Access access, std::shared_ptr<Patience> patience);

  std::filesystem::path file_;
  std::shared_ptr<Patience> patience_;
  std::unique_ptr<sqlite3, Close> connection_;
};

/// BEGIN IMMEDIATE now, ROLLBACK at the end of the scope unless commit() came first. Inside another transaction it does
/// nothing by itself: the outer one decides.
class Transaction {
 public:
  explicit Transaction(const Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  const Database& database_;
  bool outermost_;
  bool open_;
};

/// While it lives, all reads of the connection see one state of the file. A writer waits for it: keep it short.
class Snapshot {
 public:
  explicit Snapshot(const Database& database);
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;
  ~Snapshot();

 private:
  const Database& database_;
};

}  // namespace rouleau::campaign
