// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes results into a new SQLite database, whose tables docs/results-database.md explains. Nothing is at the path
// before all of it is: it is written to a temporary file beside it, which is renamed at the end and removed when there
// is none. Memory stays the same however many records there are. The same records in the same order, by the same
// version of SQLite, give the same bytes.
//
//   Writer writer("results.sqlite");
//   parts.each([&](const Record& record) { writer.add(record); });
//   writer.finish();
//
// All of it throws `DatabaseError`; in a build without SQLite the constructor does.

#pragma once

#include <memory>
#include <string>

#include <rigor/results/record.h>

namespace rigor::results {

/// Whether a path means a database by its ending: .sqlite or .db.
bool names_database(const std::string& path);

/// "3.40.1"; empty in a build without SQLite.
std::string sqlite_version();

class Writer {
 public:
  explicit Writer(const std::string& path);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// A model that was both checked and simulated is one row, by its path.
  void add(const Record& record);

  /// Once, after the last record.
  void finish();

 private:
  class Tables;
  class TemporaryFile;

  std::unique_ptr<TemporaryFile> file_;
  std::unique_ptr<Tables> tables_;
};

}  // namespace rigor::results
