// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/reader.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include <rigor/results/schema.h>
#include <rigor/results/sqlite.h>

namespace rigor::results {
namespace {

constexpr std::string_view kModelColumns =
    "models.id, models.path, kind, version, links, joints, errors, warnings, infos, verdict, worst";

/// Errors first.
constexpr std::string_view kBySeverity =
    "CASE severity WHEN 'error' THEN 0 WHEN 'warning' THEN 1 ELSE 2 END";
constexpr std::string_view kByVerdict =
    "CASE verdict WHEN 'invalid' THEN 0 WHEN 'fail' THEN 1 WHEN 'solver' THEN 2 WHEN 'warn' THEN 3 "
    "ELSE 4 END";

std::string sql(std::string_view a, std::string_view b, std::string_view c) {
  return std::string(a) + std::string(b) + std::string(c);
}

std::uint64_t unsigned_in(const Statement& row, int column) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(row.integer(column), 0));
}

std::optional<std::int64_t> whole_in(const Statement& row, int column) {
  return row.is_null(column) ? std::nullopt : std::optional(row.integer(column));
}

ModelRow model_in(const Statement& row) {
  return {row.integer(0),
          row.text(1),
          row.text(2),
          row.text(3),
          whole_in(row, 4),
          whole_in(row, 5),
          unsigned_in(row, 6),
          unsigned_in(row, 7),
          unsigned_in(row, 8),
          row.text(9),
          static_cast<Worst>(std::clamp<std::int64_t>(row.integer(10), 0, 3))};
}

std::optional<std::array<double, 3>> corner_in(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return std::array{row.real(column), row.real(column + 1), row.real(column + 2)};
}

}  // namespace

class Reader::Queries {
 public:
  explicit Queries(const std::string& path) : database_(path, Connection::Access::kRead) {
    if (database_.integer("PRAGMA application_id") != kApplicationId)
      throw DatabaseError("is no database of results of rigor");
    const std::int64_t version = database_.integer("PRAGMA user_version");
    if (version != kSchemaVersion) {
      throw DatabaseError("has tables of version " + std::to_string(version) +
                          ", and this rigor reads version " + std::to_string(kSchemaVersion));
    }
    details_ = std::make_unique<Details>(database_);
  }

  Totals totals() const {
    Totals totals;
    totals.checked = count("SELECT cases FROM commands WHERE command = 'validate'");
    totals.simulated = count("SELECT cases FROM commands WHERE command = 'simulate'");
    totals.models = count("SELECT count(*) FROM models");
    for (std::size_t worst = 0; worst < totals.by_worst.size(); ++worst)
      totals.by_worst[worst] =
          count("SELECT count(*) FROM models WHERE worst = " + std::to_string(worst));
    Statement verdicts = database_.prepare(sql(
        "SELECT verdict, count(*) FROM models WHERE verdict IS NOT NULL GROUP BY verdict ORDER BY ",
        kByVerdict, ""));
    while (verdicts.step())
      totals.by_verdict.emplace_back(verdicts.text(0), unsigned_in(verdicts, 1));
    totals.skipped = count("SELECT count(*) FROM skipped");
    totals.meshes = count("SELECT count(*) FROM meshes");
    totals.mesh_uses = count("SELECT count(*) FROM model_meshes");
    return totals;
  }

  std::vector<RuleTotal> rules() const {
    std::vector<RuleTotal> rules;
    Statement row = database_.prepare(
        sql("SELECT rule, category, severity, count(*), count(DISTINCT model_id) AS models "
            "FROM findings JOIN rules USING(rule) GROUP BY rule, severity ORDER BY ",
            kBySeverity, ", models DESC, rule"));
    while (row.step()) {
      rules.push_back(
          {row.text(0), row.text(1), row.text(2), unsigned_in(row, 3), unsigned_in(row, 4)});
    }
    return rules;
  }

  void each_model(const std::function<void(const ModelRow&)>& model) const {
    Statement row = database_.prepare(
        sql("SELECT ", kModelColumns, " FROM models ORDER BY worst DESC, errors DESC, path"));
    while (row.step()) model(model_in(row));
  }

  void models_of(const RuleTotal& rule, std::size_t limit,
                 const std::function<void(const ModelRow&, std::uint64_t)>& model) const {
    Statement row = database_.prepare(
        sql("SELECT ", kModelColumns,
            ", found FROM (SELECT model_id, count(*) AS found FROM findings WHERE rule = ? AND "
            "severity = ? GROUP BY model_id) JOIN models ON models.id = model_id ORDER BY path "
            "LIMIT ?"));
    row.bind(1, rule.rule).bind(2, rule.severity).bind(3, static_cast<std::uint64_t>(limit));
    while (row.step()) model(model_in(row), unsigned_in(row, 11));
  }

  ModelDetails details(std::int64_t model, const DetailLimits& limits) {
    ModelDetails found;
    const auto each = [model](Statement& row, std::size_t limit, std::uint64_t& all,
                              const auto& take) {
      row.bind(1, model);
      for (all = 0; row.step(); ++all) {
        if (all < limit) take(row);
      }
    };
    each(details_->findings, limits.findings, found.all_findings, [&](const Statement& row) {
      found.findings.push_back({row.text(0),
                                row.text(1),
                                {row.text(3), whole_in(row, 4), whole_in(row, 5), std::nullopt,
                                 std::nullopt, row.text(6), row.text(7)},
                                unsigned_in(row, 2)});
    });
    each(details_->meshes, limits.meshes, found.all_meshes, [&](const Statement& row) {
      MeshFile mesh{row.text(0),  row.text(1),       unsigned_in(row, 2),
                    std::nullopt, corner_in(row, 4), corner_in(row, 7)};
      if (!row.is_null(3)) mesh.triangles = unsigned_in(row, 3);
      found.meshes.push_back(std::move(mesh));
    });
    std::vector<std::int64_t> cases;
    each(details_->cases, limits.cases, found.all_cases, [&](const Statement& row) {
      found.cases.push_back({row.text(1), row.text(2), {}});
      cases.push_back(row.integer(0));
    });
    for (std::size_t i = 0; i < cases.size(); ++i) found.cases[i].limits = limits_of(cases[i]);
    each(details_->skipped, limits.skipped, found.all_skipped,
         [&](const Statement& row) { found.skipped.push_back(row.text(0)); });
    return found;
  }

 private:
  struct Details {
    explicit Details(const Connection& database)
        : findings(database.prepare(
              sql("SELECT rule, severity, places, path, line, \"column\", subject, message "
                  "FROM findings JOIN places ON finding_id = findings.id AND number = 0 "
                  "WHERE model_id = ? ORDER BY ",
                  kBySeverity, ", findings.id"))),
          meshes(database.prepare(
              "SELECT path, digest, bytes, triangles, min_x, min_y, min_z, max_x, max_y, max_z "
              "FROM model_meshes JOIN meshes ON meshes.id = mesh_id WHERE model_id = ? "
              "ORDER BY path")),
          cases(database.prepare(
              sql("SELECT id, name, verdict FROM cases WHERE model_id = ? ORDER BY ", kByVerdict,
                  ", id"))),
          metrics(database.prepare(
              "SELECT test, metric, value, unit FROM runs JOIN metrics ON run_id = runs.id WHERE "
              "case_id = ? AND metrics.verdict NOT IN ('pass', '') ORDER BY runs.id, metric")),
          skipped(database.prepare("SELECT what FROM skipped WHERE model_id = ? ORDER BY rowid")) {}

    Statement findings, meshes, cases, metrics, skipped;
  };

  std::uint64_t count(const std::string& statement) const {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(database_.integer(statement), 0));
  }

  std::string limits_of(std::int64_t one_case) {
    constexpr int kMaxMetrics = 4;
    std::string text;
    int metrics = 0;
    details_->metrics.bind(1, one_case);
    while (details_->metrics.step()) {
      if (++metrics > kMaxMetrics) continue;
      char value[32];
      std::snprintf(value, sizeof(value), "%.3g", details_->metrics.real(2));
      if (!text.empty()) text += "; ";
      text += details_->metrics.text(0) + ' ' + details_->metrics.text(1) + ' ' + value;
      if (const std::string unit = details_->metrics.text(3); !unit.empty()) text += ' ' + unit;
    }
    if (metrics > kMaxMetrics) text += "; and " + std::to_string(metrics - kMaxMetrics) + " more";
    return text;
  }

  Connection database_;
  std::unique_ptr<Details> details_;
};

Reader::Reader(const std::string& path) : queries_(std::make_unique<Queries>(path)) {}
Reader::~Reader() = default;

Totals Reader::totals() const { return queries_->totals(); }
std::vector<RuleTotal> Reader::rules() const { return queries_->rules(); }

void Reader::each_model(const std::function<void(const ModelRow&)>& model) const {
  queries_->each_model(model);
}

ModelDetails Reader::details(std::int64_t model, const DetailLimits& limits) const {
  return queries_->details(model, limits);
}

void Reader::models_of(const RuleTotal& rule, std::size_t limit,
                       const std::function<void(const ModelRow&, std::uint64_t)>& model) const {
  queries_->models_of(rule, limit, model);
}

}  // namespace rigor::results
