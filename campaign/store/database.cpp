// SPDX-License-Identifier: BSD-3-Clause
// The connection: how the file is opened, and SQLite's errors as ours.
#include "store/database.hpp"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <thread>

#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto reader_wait = std::chrono::seconds(1);
constexpr int writer_wait_ms = 10000;
constexpr const char* probe = "SELECT count(*) FROM sqlite_schema;";
constexpr auto shortest_pause = std::chrono::milliseconds(1), longest_pause = std::chrono::milliseconds(25);

/// Who holds the campaign's lock beside the database, in the holder's own words, if anybody does.
std::string writer_of(const std::filesystem::path& file) {
  const std::filesystem::path lock = file.parent_path() / ".lock";
  const int descriptor = ::open(lock.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_held = descriptor >= 0 && ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (descriptor >= 0) ::close(descriptor);
  std::string holder;
  if (is_held) {
    std::ifstream text(lock);
    std::getline(text, holder);
  }
  return holder.empty() ? "another process" : holder;
}

/// The errno of the last call on the database's file that failed, 0 if none has. Of a page that the medium does not
/// give, SQLite says the same as of a damaged one.
int last_errno(sqlite3* connection) {
  int number = 0;
  sqlite3_file_control(connection, "main", SQLITE_FCNTL_LAST_ERRNO, &number);
  return number;
}

/// True if the path names another file by now. SQLite says so too when it only could not look.
bool has_moved(sqlite3* connection) {
  int moved = 1;
  sqlite3_file_control(connection, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

/// `unopened`: the file of a connection that could not be opened.
[[noreturn]] void fail_with(sqlite3* connection, std::string_view doing, const std::filesystem::path& unopened = {}) {
  const char* name = unopened.empty() ? sqlite3_db_filename(connection, "main") : unopened.c_str();
  const int code = connection == nullptr ? SQLITE_NOMEM : sqlite3_extended_errcode(connection);
  std::string message = connection == nullptr ? "out of memory" : sqlite3_errmsg(connection);
  std::string advice = "`rouleau verify` checks the campaign";
  enum { of_statement, passing, lasting } kind = passing;
  Exit exit = Exit::failed;
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      // Who writes has the campaign's lock itself: what it waits for is no rouleau.
      advice = connection != nullptr && sqlite3_db_readonly(connection, "main") == 0
                   ? "another program, such as a query in sqlite3 that has not come to its end, keeps it open; end "
                     "that and try again"
                   : writer_of(name) + " is writing; try again in a moment";
      break;
    case SQLITE_ERROR:  // our statements are always the same: a table or column that they miss was damaged
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
      if (const int number = last_errno(connection); number != 0) {
        message = std::strerror(number);
        advice =
            "the disk does not give what is in the file; try again when it does, and if it never will, `rouleau "
            "rebuild` makes the file anew from the run directories";
        break;
      }
      advice = "the file is damaged; `rouleau rebuild` makes it anew from the run directories";
      kind = lasting;
      exit = Exit::damaged;
      break;
    case SQLITE_FULL:
      advice = "the disk is full; make room and try again";
      break;
    case SQLITE_IOERR:  // a quota that is used up is one of these
      advice = "see that the disk is sound and that it and your quota have room, then try again";
      break;
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      if (code == SQLITE_READONLY_DBMOVED && has_moved(connection)) {
        advice = "the file was moved, removed or replaced while it was open; give the same command again";
        kind = lasting;
        break;
      }
      advice = "see that the file and its directory exist and are yours to write, and that the disk has room";
      break;
    case SQLITE_NOMEM:
      break;
    default:
      kind = of_statement;
      break;
  }
  const std::string text = fmt::format("{}: {}: {} (SQLite {}); {}", name, doing, message, code, advice);
  if (kind == of_statement) throw Error(exit, text);
  throw DatabaseError(exit, text, kind == passing);
}

int open_flags(Access access) {
  switch (access) {
    case Access::read_only:
      return SQLITE_OPEN_READONLY;
    case Access::read_write:
      return SQLITE_OPEN_READWRITE;
    case Access::create:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return SQLITE_OPEN_READONLY;
}

}  // namespace

/// How long a reader still waits for writers: a second for all its statements together. One that nobody has kept
/// waiting for a second starts afresh, so that a long export does not end because of many short waits.
class Database::Patience {
 public:
  /// Waits a little.   returns false when there is no patience left
  bool wait() {
    const Clock::time_point now = Clock::now();
    if (now - last_ > reader_wait) {
      end_ = now + reader_wait;
      pause_ = shortest_pause;
    }
    last_ = now;
    if (now >= end_) return false;
    std::this_thread::sleep_for(std::min<Clock::duration>(pause_, end_ - now));
    pause_ = std::min(2 * pause_, longest_pause);
    last_ = Clock::now();
    return true;
  }

 private:
  Clock::time_point last_ = Clock::now() - 2 * reader_wait;  ///< when it last waited
  Clock::time_point end_;                                    ///< of the patience
  std::chrono::milliseconds pause_ = shortest_pause;
};

void Database::Close::operator()(sqlite3* connection) const { sqlite3_close_v2(connection); }

Database::Database(const std::filesystem::path& file, Access access)
    : Database(file, access, access == Access::read_only ? std::make_shared<Patience>() : nullptr) {}

Database::Database(const std::filesystem::path& file, Access access, std::shared_ptr<Patience> patience)
    : file_(file), patience_(std::move(patience)) {
  if (access == Access::create && std::filesystem::exists(file))
    fail(Exit::failed, "{}: exists already; it is not written over", file.string());
  if (access != Access::create && !std::filesystem::exists(file))
    fail(Exit::not_found, "{}: there is no such database; `rouleau init STUDY DIR` makes a campaign", file.string());
  sqlite3* connection = nullptr;
  const int result = sqlite3_open_v2(file.c_str(), &connection, open_flags(access) | SQLITE_OPEN_EXRESCODE, nullptr);
  connection_.reset(connection);
  if (result != SQLITE_OK) fail_with(connection, "opening", file);
  // SQLite opens a file that it cannot open for writing for reading, without a word and for good.
  if (access != Access::read_only && sqlite3_db_readonly(connection, "main") == 1)
    throw DatabaseError(Exit::failed,
                        fmt::format("{}: cannot be opened for writing; see that the file and its directory are yours "
                                    "to write, and that the disk is sound and has room",
                                    file.string()),
                        true);
  if (patience_)
    sqlite3_busy_handler(
        connection, [](void* of_reader, int) { return static_cast<Patience*>(of_reader)->wait() ? 1 : 0; },
        patience_.get());
  else
    sqlite3_busy_timeout(connection, writer_wait_ms);

  if (access == Access::read_only) {
    const int code = sqlite3_exec(connection, probe, nullptr, nullptr, nullptr) & 0xff;
    if (code == SQLITE_BUSY) fail_with(connection, "reading");
    // A writer that was killed in the middle of a commit leaves a journal that the next opener must roll back, which a
    // read-only connection cannot: a writing one does it here, by reading a page, and changes nothing else.
    if (code == SQLITE_READONLY || code == SQLITE_CANTOPEN)
      Database(file, Access::read_write, patience_).execute(probe);
    execute("PRAGMA query_only = ON;");
  } else {
    // EXTRA also syncs the directory after the journal is gone: a commit survives the loss of power.
    execute("PRAGMA journal_mode = DELETE; PRAGMA synchronous = EXTRA;");
  }
  execute(
      "PRAGMA foreign_keys = ON; PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; "
      "PRAGMA temp_store = MEMORY;");
}

Statement Database::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(connection_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr) != SQLITE_OK)
    fail_with(connection_.get(), "preparing a statement");
  return {connection_.get(), statement};
}

void Database::execute(const std::string& sql) const {
  if (sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail_with(connection_.get(), "running a statement");
}

Rows Database::select(std::string_view sql, std::span<const Value> values) const {
  Statement statement = prepare(sql);
  statement.bind_values(values);
  Rows answer;
  for (int column = 0; column < statement.columns(); ++column) answer.columns.push_back(statement.column_name(column));
  while (statement.step()) {
    std::vector<Value>& row = answer.rows.emplace_back();
    for (int column = 0; column < statement.columns(); ++column) row.push_back(statement.value(column));
  }
  return answer;
}

std::int64_t Database::select_integer(std::string_view sql) const {
  Statement statement = prepare(sql);
  if (!statement.step())
    fail(Exit::failed, "{}: no answer to `{}`; `rouleau verify` checks the campaign", file_.string(), sql);
  return statement.integer(0);
}

int Database::changes() const { return sqlite3_changes(connection_.get()); }

bool Database::in_transaction() const { return sqlite3_get_autocommit(connection_.get()) == 0; }

Statement::Statement(Statement&& other) noexcept : connection_(other.connection_), statement_(other.statement_) {
  other.statement_ = nullptr;
}

Statement::~Statement() { sqlite3_finalize(statement_); }

Statement& Statement::bind_values(std::span<const Value> values) {
  int index = 0;
  for (const Value& value : values) bind_one(++index, value);
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) {
    // reset() would replace the message, so it is taken first.
    fail_with(connection_, "running a statement");
  }
  return false;
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

bool Statement::is_null(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_, column); }
double Statement::real(int column) const { return sqlite3_column_double(statement_, column); }
int Statement::columns() const { return sqlite3_column_count(statement_); }
std::string Statement::column_name(int column) const { return sqlite3_column_name(statement_, column); }

std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return bytes == nullptr ? std::string()
                          : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}

Value Statement::value(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return integer(column);
    case SQLITE_FLOAT:
      return real(column);
    case SQLITE_NULL:
      return std::monostate{};
    default:
      return text(column);
  }
}

std::optional<double> Statement::optional_real(int column) const {
  return is_null(column) ? std::nullopt : std::optional(real(column));
}

std::optional<std::int64_t> Statement::optional_integer(int column) const {
  return is_null(column) ? std::nullopt : std::optional(integer(column));
}

void Statement::bind_one(int index, std::nullptr_t) {
  if (sqlite3_bind_null(statement_, index) != SQLITE_OK) fail_with(connection_, "binding a value");
}

void Statement::bind_one(int index, std::int64_t value) {
  if (sqlite3_bind_int64(statement_, index, value) != SQLITE_OK) fail_with(connection_, "binding a value");
}

void Statement::bind_one(int index, double value) {
  // SQLite stores NaN as NULL in silence; who calls decides what such a value means.
  require(std::isfinite(value), "a number that is not finite was handed to the database");
  if (sqlite3_bind_double(statement_, index, value) != SQLITE_OK) fail_with(connection_, "binding a value");
}

void Statement::bind_one(int index, std::string_view value) {
  if (sqlite3_bind_text(statement_, index, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT) != SQLITE_OK)
    fail_with(connection_, "binding a value");
}

void Statement::bind_one(int index, const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) {
    bind_one(index, nullptr);
  } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    bind_one(index, *integer);
  } else if (const auto* real = std::get_if<double>(&value)) {
    bind_one(index, *real);
  } else {
    bind_one(index, std::string_view(std::get<std::string>(value)));
  }
}

namespace {

/// SQLite may have rolled back by itself (disk full); a failing end leaves nothing that a destructor could mend.
void end_quietly(const Database& database, const char* how) {
  if (!database.in_transaction()) return;
  try {
    database.execute(how);
  } catch (const Error&) {
  }
}

}  // namespace

Transaction::Transaction(const Database& database)
    : database_(database), outermost_(!database.in_transaction()), open_(true) {
  if (outermost_) database_.execute("BEGIN IMMEDIATE;");
}

Transaction::~Transaction() {
  if (open_ && outermost_) end_quietly(database_, "ROLLBACK;");
}

void Transaction::commit() {
  require(open_, "a transaction was committed twice");
  if (outermost_) database_.execute("COMMIT;");
  open_ = false;
}

Snapshot::Snapshot(const Database& database) : database_(database) { database_.execute("BEGIN;"); }

Snapshot::~Snapshot() { end_quietly(database_, "COMMIT;"); }

}  // namespace rouleau::campaign
