// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a page or a person asks of a database of results, without SQL. A file that somebody else made is read as
// data alone. Memory does not grow with the number of models.
//
//   Reader reader("results.sqlite");
//   for (const RuleTotal& rule : reader.rules()) say(rule.rule, rule.findings);
//   reader.each_model([&](const ModelRow& model) { show(model, reader.details(model.id, {})); });
//
// All of it throws `DatabaseError`: of a file that is no database of results, or of a later schema. In a build without
// SQLite the constructor does.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/results/record.h>

namespace rigor::results {

/// `models.worst`: the severest of a model's findings and verdicts.
enum class Worst : std::uint8_t { kClean, kInfo, kWarning, kError };

struct Totals {
  std::uint64_t checked = 0;    ///< files; 0 when nothing was validated
  std::uint64_t simulated = 0;  ///< cases; 0 when nothing was simulated
  std::uint64_t models = 0;
  std::array<std::uint64_t, 4> by_worst{};                        ///< models, by `Worst`
  std::vector<std::pair<std::string, std::uint64_t>> by_verdict;  ///< models that were simulated
  std::uint64_t skipped = 0;  ///< things that were not checked or simulated
  std::uint64_t meshes = 0;   ///< files of different bytes
  std::uint64_t mesh_uses = 0;
};

struct RuleTotal {
  std::string rule;
  std::string category;
  std::string severity;
  std::uint64_t findings = 0;
  std::uint64_t models = 0;
};

struct ModelRow {
  std::int64_t id = 0;
  std::string path;
  std::string kind;  ///< empty when it was only simulated; so are the next four
  std::string version;
  std::optional<std::int64_t> links;
  std::optional<std::int64_t> joints;
  std::uint64_t errors = 0;
  std::uint64_t warnings = 0;
  std::uint64_t infos = 0;
  std::string verdict;  ///< empty when it was not simulated
  Worst worst = Worst::kClean;
};

/// How many of a model's rows are read; the others are counted.
struct DetailLimits {
  std::size_t findings = 200;
  std::size_t meshes = 100;
  std::size_t cases = 100;
  std::size_t skipped = 50;
};

struct FindingRow {
  std::string rule;
  std::string severity;
  Place place;  ///< the first
  std::uint64_t places = 1;
};

struct CaseRow {
  std::string name;
  std::string verdict;
  std::string limits;  ///< metrics beyond a limit: "settle tilt.max 0.6 rad"
};

struct ModelDetails {
  std::vector<FindingRow> findings;  ///< errors first
  std::vector<MeshFile> meshes;
  std::vector<CaseRow> cases;  ///< the worst first
  std::vector<std::string> skipped;
  std::uint64_t all_findings = 0;
  std::uint64_t all_meshes = 0;
  std::uint64_t all_cases = 0;
  std::uint64_t all_skipped = 0;
};

class Reader {
 public:
  explicit Reader(const std::string& path);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  Totals totals() const;

  /// Errors first, then by the number of models. A rule is there once for each severity.
  std::vector<RuleTotal> rules() const;

  /// The worst first, then those with most errors, then by path.
  void each_model(const std::function<void(const ModelRow&)>& model) const;

  ModelDetails details(std::int64_t model, const DetailLimits& limits) const;

  /// Models that a rule found something in with a severity, by path: the first `limit`.
  void models_of(const RuleTotal& rule, std::size_t limit,
                 const std::function<void(const ModelRow&, std::uint64_t findings)>& model) const;

 private:
  class Queries;

  std::unique_ptr<Queries> queries_;
};

}  // namespace rigor::results
