// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// docs/results-database.md is the manual of the tables: each of its tables and columns is there and no other, and its
// queries run.

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/results/sqlite.h>

#include "results/result_lines.h"
#include "support/corpus.h"

namespace rigor::results {
namespace {

using TableColumns = std::map<std::string, std::vector<std::string>>;

std::string manual_text() {
  return test::read_file(std::string(RIGOR_SOURCE_DIR) + "/docs/results-database.md");
}

TableColumns tables_of_manual() {
  TableColumns tables;
  std::istringstream text(manual_text());
  std::string table;
  const std::regex head("### (\\w+)");
  const std::regex row("\\| `(\\w+)` \\|.*");
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_match(line, match, head)) table = match[1];
    if (!table.empty() && std::regex_match(line, match, row)) tables[table].push_back(match[1]);
  }
  return tables;
}

TableColumns tables_of_database(const Connection& database) {
  TableColumns tables;
  Statement names = database.prepare("SELECT name FROM sqlite_master WHERE type = 'table'");
  while (names.step()) {
    Statement columns =
        database.prepare("SELECT name FROM pragma_table_info('" + names.text(0) + "')");
    while (columns.step()) tables[names.text(0)].push_back(columns.text(0));
  }
  return tables;
}

std::vector<std::string> queries_of_manual() {
  std::vector<std::string> queries;
  const std::string text = manual_text();
  const std::string open = "```sql\n";
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    queries.push_back(text.substr(at, text.find("```", at) - at));
  }
  return queries;
}

class ResultsManual : public testing::Test {
 protected:
  ResultsManual() { write_database(lines_of_both(60), 2, path_); }

  ResultsFolder folder_;
  std::string path_ = folder_.path("results.sqlite");
};

TEST_F(ResultsManual, NamesEveryTableAndColumn) {
  EXPECT_EQ(tables_of_manual(), tables_of_database(Connection(path_, Connection::Access::kRead)));
}

TEST_F(ResultsManual, ItsQueriesRun) {
  const Connection database(path_, Connection::Access::kRead);
  std::vector<int> rows;
  for (const std::string& query : queries_of_manual()) {
    Statement statement = database.prepare(query);
    rows.push_back(0);
    while (statement.step()) ++rows.back();
  }
  // Two rules; the worst 20; both findings of model 0; two meshes; of the 12 that tip over 4 have errors; one include.
  EXPECT_EQ(rows, (std::vector<int>{2, 20, 2, 2, 8, 1}));
}

}  // namespace
}  // namespace rigor::results
