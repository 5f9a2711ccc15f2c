// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/writer.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/results/line.h>
#include <rigor/results/reader.h>
#include <rigor/results/sqlite.h>

#include "results/result_lines.h"
#include "support/corpus.h"

namespace rigor::results {
namespace {

constexpr std::size_t kSomeModels = 60;

class ResultsWriter : public testing::Test {
 protected:
  ResultsWriter() { write_database(lines_of_both(kSomeModels), 3, path_); }

  std::int64_t ask(const std::string& query) const {
    return Connection(path_, Connection::Access::kRead).integer(query);
  }

  ResultsFolder folder_;
  std::string path_ = folder_.path("results.sqlite");
};

TEST_F(ResultsWriter, SqliteItselfFindsNothingWrong) {
  const Connection database(path_, Connection::Access::kRead);
  Statement check = database.prepare("PRAGMA integrity_check");
  ASSERT_TRUE(check.step());
  EXPECT_EQ(check.text(0), "ok");
  EXPECT_FALSE(database.prepare("PRAGMA foreign_key_check").step()) << "a row refers to none";
}

TEST_F(ResultsWriter, TheSameResultsAreTheSameBytes) {
  const std::string bytes = test::read_file(path_);
  std::vector<std::string> lines = lines_of_both(kSomeModels);
  std::mt19937 random(2);
  for (const std::size_t files : {1U, 2U, 40U}) {
    std::shuffle(lines.begin(), lines.end(), random);
    const std::string other = folder_.path("other.db");
    write_database(lines, files, other);
    EXPECT_EQ(test::read_file(other), bytes) << files;
  }
}

TEST_F(ResultsWriter, RowsAreAsManyAsTheLinesSay) {
  EXPECT_EQ(ask("SELECT count(*) FROM models"), 60);
  EXPECT_EQ(ask("SELECT count(*) FROM findings"), 20 + 15);
  EXPECT_EQ(ask("SELECT count(*) FROM places"), 20 + 15 * 2);
  EXPECT_EQ(ask("SELECT sum(places) FROM findings"), 20 + 15 * 2);
  EXPECT_EQ(ask("SELECT count(*) FROM meshes"), 2) << "by their digests";
  EXPECT_EQ(ask("SELECT count(*) FROM model_meshes"), 60);
  EXPECT_EQ(ask("SELECT count(*) FROM cases"), 60);
  EXPECT_EQ(ask("SELECT count(*) FROM metrics"), 120);
  EXPECT_EQ(ask("SELECT count(*) FROM metrics WHERE value IS NULL"), 60);
  EXPECT_EQ(ask("SELECT count(*) FROM skipped"), 1);
  // Of 60 numbers 20 are divided by 3, 12 by 5 and 4 by both; 15 by 4, 5 of those by 3, 3 by 5, 1 by all.
  EXPECT_EQ(ask("SELECT count(*) FROM models WHERE worst = 3"), 20 + 12 - 4);
  EXPECT_EQ(ask("SELECT count(*) FROM models WHERE worst = 2"), 15 - 5 - 3 + 1);
  EXPECT_EQ(ask("SELECT count(*) FROM models WHERE verdict = 'fail'"), 12);
}

TEST_F(ResultsWriter, AModelThatWasOnlySimulatedIsARow) {
  const std::string path = folder_.path("simulated.db");
  write_database({simulated_line(0, 1)}, 1, path);
  const Connection database(path, Connection::Access::kRead);
  EXPECT_EQ(database.integer("SELECT count(*) FROM models WHERE kind IS NULL AND worst = 3"), 1);
  EXPECT_EQ(database.integer("SELECT count(*) FROM commands"), 1);
}

TEST_F(ResultsWriter, NothingIsThereUntilItIsWhole) {
  const std::string before = test::read_file(path_);
  {
    Writer writer(path_);
    writer.add(*record_of(checked_line(0, 1)));
    EXPECT_EQ(test::read_file(path_), before);
  }
  EXPECT_EQ(test::read_file(path_), before);
  EXPECT_EQ(folder_.files(), 1U) << "the temporary file is gone";
  EXPECT_THROW(Writer(folder_.path("none/results.db")), DatabaseError);
  EXPECT_THROW(Writer(folder_.path("")), DatabaseError) << "a folder";
}

TEST_F(ResultsWriter, TheReaderCountsTheSame) {
  const Reader reader(path_);
  const Totals totals = reader.totals();
  EXPECT_EQ(totals.checked, 60U);
  EXPECT_EQ(totals.simulated, 60U);
  EXPECT_EQ(totals.by_worst, (std::array<std::uint64_t, 4>{24, 0, 8, 28}));
  EXPECT_EQ(totals.meshes, 2U);
  const std::vector<RuleTotal> rules = reader.rules();
  ASSERT_EQ(rules.size(), 2U);
  EXPECT_EQ(rules[0].rule, "inertia-not-physical") << "errors are first";
  EXPECT_EQ(rules[0].models, 20U);
  EXPECT_EQ(rules[1].findings, 15U);
  std::size_t models = 0;
  Worst last = Worst::kError;
  reader.each_model([&](const ModelRow& model) {
    EXPECT_LE(model.worst, last) << model.path;
    last = model.worst;
    ++models;
  });
  EXPECT_EQ(models, 60U);
  std::size_t of_rule = 0;
  reader.models_of(rules[1], 7, [&](const ModelRow&, std::uint64_t) { ++of_rule; });
  EXPECT_EQ(of_rule, 7U);
}

TEST_F(ResultsWriter, TheReaderRefusesWhatIsNoDatabaseOfResults) {
  const std::string text = folder_.path("text.db");
  std::ofstream(text) << "no database, but more than the hundred bytes that a header takes: "
                      << std::string(200, '-');
  EXPECT_THROW(Reader{text}, DatabaseError);
  EXPECT_THROW(Reader{folder_.path("none.db")}, DatabaseError);
  const std::string other = folder_.path("other.db");
  std::ofstream(other).close();
  Connection(other, Connection::Access::kWrite).run("CREATE TABLE t(a)");
  EXPECT_THROW(Reader{other}, DatabaseError) << "somebody else's";
  Connection(path_, Connection::Access::kWrite).run("PRAGMA user_version = 2");
  EXPECT_THROW(Reader{path_}, DatabaseError) << "of a later version";
}

}  // namespace
}  // namespace rigor::results
