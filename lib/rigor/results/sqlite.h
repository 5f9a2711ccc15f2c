// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SQLite's handles as values that release themselves, its errors as exceptions.
//
//   Connection database(path, Connection::Access::kWrite);
//   database.run("CREATE TABLE t(a)");
//   Statement insert = database.prepare("INSERT INTO t VALUES(?)");
//   insert.bind(1, "text").run();

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <sqlite3.h>

namespace rigor::results {

/// Parameters and columns are numbered as SQLite numbers them: parameters from 1, columns from 0. All of it throws
/// `DatabaseError`.
class Statement {
 public:
  /// The text stays valid until the statement is run.
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, std::uint64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind_null(int parameter);

  template <class Value>
  Statement& bind(int parameter, const std::optional<Value>& value) {
    return value ? bind(parameter, *value) : bind_null(parameter);
  }

  /// To its end; then it can be bound and run again.
  void run();

  /// To the next row; false when there is none, and then it can be bound and run again.
  bool step();
  void reset();

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;

 private:
  friend class Connection;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}
  [[noreturn]] void fail() const;
  Statement& checked(int code);

  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class Connection {
 public:
  enum class Access : std::uint8_t { kRead, kWrite };

  /// Of an existing file; an empty one is a database without tables.
  Connection(const std::string& path, Access access);

  /// Statements, separated by semicolons, without parameters and rows.
  void run(const std::string& statements);
  Statement prepare(std::string_view statement) const;
  /// The only value of the only row.
  std::int64_t integer(std::string_view statement) const;
  /// Throws when what was written is not with the system.
  void close();

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
  };
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace rigor::results
