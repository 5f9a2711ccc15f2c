// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/sqlite.h>

#include <limits>

#include <rigor/results/record.h>

namespace rigor::results {

void Statement::fail() const {
  throw DatabaseError(sqlite3_errmsg(sqlite3_db_handle(statement_.get())));
}

Statement& Statement::checked(int code) {
  if (code != SQLITE_OK) fail();
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  const char* const begin = text.empty() ? "" : text.data();  // null would bind NULL
  return checked(sqlite3_bind_text64(statement_.get(), parameter, begin, text.size(), SQLITE_STATIC,
                                     SQLITE_UTF8));
}

Statement& Statement::bind(int parameter, std::int64_t value) {
  return checked(sqlite3_bind_int64(statement_.get(), parameter, value));
}

Statement& Statement::bind(int parameter, std::uint64_t value) {
  constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  return bind(parameter, static_cast<std::int64_t>(value < kMax ? value : kMax));
}

Statement& Statement::bind(int parameter, double value) {
  return checked(sqlite3_bind_double(statement_.get(), parameter, value));
}

Statement& Statement::bind_null(int parameter) {
  return checked(sqlite3_bind_null(statement_.get(), parameter));
}

void Statement::run() {
  while (step()) {
  }
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) fail();
  reset();
  return false;
}

void Statement::reset() { checked(sqlite3_reset(statement_.get())); }

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::string Statement::text(int column) const {
  const auto* const begin =
      reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  if (begin == nullptr) return {};
  return {begin, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

Connection::Connection(const std::string& path, Access access) {
  sqlite3* database = nullptr;
  const int flags = access == Access::kWrite ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY;
  const int code = sqlite3_open_v2(path.c_str(), &database, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) throw DatabaseError(sqlite3_errstr(code));
  // A file that somebody else made must not run functions from its schema.
  run("PRAGMA trusted_schema = OFF");
}

void Connection::run(const std::string& statements) {
  if (sqlite3_exec(database_.get(), statements.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    throw DatabaseError(sqlite3_errmsg(database_.get()));
}

Statement Connection::prepare(std::string_view statement) const {
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(database_.get(), statement.data(), static_cast<int>(statement.size()),
                         &prepared, nullptr) != SQLITE_OK)
    throw DatabaseError(sqlite3_errmsg(database_.get()));
  return Statement(prepared);
}

std::int64_t Connection::integer(std::string_view statement) const {
  Statement prepared = prepare(statement);
  return prepared.step() ? prepared.integer(0) : 0;
}

void Connection::close() {
  sqlite3* const database = database_.release();
  if (const int code = sqlite3_close(database); code != SQLITE_OK) {
    database_.reset(database);
    throw DatabaseError(sqlite3_errstr(code));
  }
}

}  // namespace rigor::results
