// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/writer.h>

#include <algorithm>
#include <string_view>
#include <variant>

#include <rigor/results/schema.h>
#include <rigor/results/sqlite.h>
#include <rigor/results/temporary_file.h>

namespace rigor::results {
namespace {

/// Nobody reads the file before it is whole, and what is interrupted is thrown away: no journal, and one wait for the
/// disk at the end.
constexpr std::string_view kSettings =
    "PRAGMA page_size = 4096; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; "
    "PRAGMA locking_mode = EXCLUSIVE; PRAGMA encoding = 'UTF-8';";

constexpr std::int64_t kWorstError = 3;
constexpr std::int64_t kWorstWarning = 2;
constexpr std::int64_t kWorstInfo = 1;

struct Counts {
  std::int64_t errors = 0;
  std::int64_t warnings = 0;
  std::int64_t infos = 0;

  std::int64_t worst() const {
    if (errors > 0) return kWorstError;
    if (warnings > 0) return kWorstWarning;
    return infos > 0 ? kWorstInfo : 0;
  }
};

Counts count_of(const std::vector<Finding>& findings) {
  Counts counts;
  for (const Finding& each : findings) {
    if (each.severity == "error") ++counts.errors;
    if (each.severity == "warning") ++counts.warnings;
    if (each.severity == "info") ++counts.infos;
  }
  return counts;
}

/// As severe as a finding.
std::int64_t worst_of(std::string_view verdict) {
  if (verdict == "fail" || verdict == "invalid") return kWorstError;
  return verdict == "warn" || verdict == "solver" ? kWorstWarning : 0;
}

/// The order of verdicts, the worst last; one that is unknown is before all.
int rank_of(std::string_view verdict) {
  constexpr std::string_view kOrder[] = {"pass", "warn", "solver", "fail", "invalid"};
  const auto* const found = std::find(std::begin(kOrder), std::end(kOrder), verdict);
  return found == std::end(kOrder) ? -1 : static_cast<int>(found - std::begin(kOrder));
}

}  // namespace

/// Rows are numbered in the order in which they are written.
class Writer::Tables {
 public:
  explicit Tables(const std::string& path) : database_(path, Connection::Access::kWrite) {
    database_.run(std::string(kSettings) +
                  "PRAGMA application_id = " + std::to_string(kApplicationId) +
                  "; PRAGMA user_version = " + std::to_string(kSchemaVersion) + "; BEGIN;" +
                  std::string(tables()));
    statements_ = std::make_unique<Statements>(database_);
  }

  void add(const CheckedFile& file) {
    totals_[0] = file.one.of;
    const Counts counts = count_of(file.findings);
    const std::int64_t model = ++models_;
    statements_->model.bind(1, model).bind(2, file.path).bind(3, file.kind).bind(4, file.version);
    statements_->model.bind(5, file.models).bind(6, file.links).bind(7, file.joints);
    statements_->model.bind(8, counts.errors).bind(9, counts.warnings).bind(10, counts.infos);
    statements_->model.bind(11, counts.worst()).run();
    for (const std::string& what : file.skipped) skip(model, std::nullopt, what);
    for (const MeshFile& mesh : file.meshes) add(model, mesh);
    for (const Finding& finding : file.findings) add(model, std::nullopt, finding);
  }

  void add(const SimulatedCase& simulated) {
    totals_[1] = simulated.one.of;
    const std::int64_t model = model_of(simulated);
    const std::int64_t number = ++cases_;
    statements_->one_case.bind(1, number).bind(2, model).bind(3, simulated.one.id);
    statements_->one_case.bind(4, simulated.verdict).run();
    for (const std::string& what : simulated.skipped) skip(model, number, what);
    for (const Run& run : simulated.runs) add(number, run);
    for (const Finding& finding : simulated.findings) add(model, number, finding);
  }

  void finish() {
    constexpr std::string_view kCommands[] = {"simulate", "validate"};
    for (const std::string_view command : kCommands) {
      const std::uint64_t cases = totals_[command == "validate" ? 0 : 1];
      if (cases > 0) statements_->command.bind(1, command).bind(2, cases).run();
    }
    statements_.reset();
    database_.run(std::string(indexes()) + "COMMIT;");
    database_.close();
  }

 private:
  struct Statements {
    explicit Statements(const Connection& database)
        : command(database.prepare("INSERT INTO commands VALUES(?,?)")),
          model(database.prepare("INSERT INTO models VALUES(?,?,?,?,?,?,?,?,?,?,NULL,?)")),
          known_model(database.prepare("SELECT id, verdict FROM models WHERE path = ?")),
          simulated_model(database.prepare(
              "INSERT INTO models VALUES(?,?,NULL,NULL,NULL,NULL,NULL,0,0,0,?,0)")),
          verdict(database.prepare(
              "UPDATE models SET errors = errors + ?, warnings = warnings + ?, infos = infos + ?, "
              "worst = max(worst, ?), verdict = ? WHERE id = ?")),
          skipped(database.prepare("INSERT INTO skipped VALUES(?,?,?)")),
          rule(database.prepare("INSERT OR IGNORE INTO rules VALUES(?,?)")),
          finding(database.prepare("INSERT INTO findings VALUES(?,?,?,?,?,?)")),
          place(database.prepare("INSERT INTO places VALUES(?,?,?,?,?,?,?,?,?)")),
          known_mesh(database.prepare("SELECT id FROM meshes WHERE digest = ?")),
          mesh(database.prepare("INSERT INTO meshes VALUES(?,?,?,?,?,?,?,?,?,?)")),
          model_mesh(database.prepare("INSERT OR IGNORE INTO model_meshes VALUES(?,?,?)")),
          one_case(database.prepare("INSERT INTO cases VALUES(?,?,?,?)")),
          run(database.prepare("INSERT INTO runs VALUES(?,?,?,?,?,?,?,?)")),
          metric(database.prepare("INSERT OR IGNORE INTO metrics VALUES(?,?,?,?,?,?,?)")) {}

    Statement command, model, known_model, simulated_model, verdict, skipped, rule, finding, place,
        known_mesh, mesh, model_mesh, one_case, run, metric;
  };

  /// Its row, with what the case adds to its counts and verdict.
  std::int64_t model_of(const SimulatedCase& simulated) {
    std::int64_t model = 0;
    std::string verdict = simulated.verdict;
    statements_->known_model.bind(1, simulated.model);
    if (statements_->known_model.step()) {
      model = statements_->known_model.integer(0);
      const std::string before = statements_->known_model.text(1);
      if (rank_of(before) > rank_of(verdict)) verdict = before;
      statements_->known_model.reset();
    } else {
      model = ++models_;
      statements_->simulated_model.bind(1, model).bind(2, simulated.model).bind(3, verdict).run();
    }
    const Counts counts = count_of(simulated.findings);
    statements_->verdict.bind(1, counts.errors).bind(2, counts.warnings).bind(3, counts.infos);
    statements_->verdict.bind(4, std::max(counts.worst(), worst_of(simulated.verdict)));
    statements_->verdict.bind(5, verdict).bind(6, model).run();
    return model;
  }

  void skip(std::int64_t model, std::optional<std::int64_t> one_case, const std::string& what) {
    statements_->skipped.bind(1, model).bind(2, one_case).bind(3, what).run();
  }

  void add(std::int64_t model, const MeshFile& mesh) {
    std::int64_t number = 0;
    statements_->known_mesh.bind(1, mesh.digest);
    if (statements_->known_mesh.step()) {
      number = statements_->known_mesh.integer(0);
      statements_->known_mesh.reset();
    } else {
      number = ++meshes_;
      statements_->mesh.bind(1, number).bind(2, mesh.digest).bind(3, mesh.bytes);
      statements_->mesh.bind(4, mesh.triangles);
      bind_corner(5, mesh.min);
      bind_corner(8, mesh.max);
      statements_->mesh.run();
    }
    statements_->model_mesh.bind(1, model).bind(2, mesh.path).bind(3, number).run();
  }

  void bind_corner(int first, const std::optional<std::array<double, 3>>& corner) {
    for (int i = 0; i < 3; ++i) {
      if (corner) {
        statements_->mesh.bind(first + i, (*corner)[static_cast<std::size_t>(i)]);
      } else {
        statements_->mesh.bind_null(first + i);
      }
    }
  }

  void add(std::int64_t model, std::optional<std::int64_t> one_case, const Finding& finding) {
    statements_->rule.bind(1, finding.rule).bind(2, finding.category).run();
    const std::int64_t number = ++findings_;
    statements_->finding.bind(1, number).bind(2, model).bind(3, one_case).bind(4, finding.rule);
    statements_->finding.bind(5, finding.severity).bind(6, 1 + finding.others.size()).run();
    add(number, 0, finding.place);
    for (std::size_t i = 0; i < finding.others.size(); ++i) add(number, i + 1, finding.others[i]);
  }

  void add(std::int64_t finding, std::size_t number, const Place& place) {
    statements_->place.bind(1, finding).bind(2, static_cast<std::uint64_t>(number));
    statements_->place.bind(3, place.path).bind(4, place.line).bind(5, place.column);
    statements_->place.bind(6, place.end_line).bind(7, place.end_column);
    statements_->place.bind(8, place.subject).bind(9, place.message).run();
  }

  void add(std::int64_t one_case, const Run& run) {
    const std::int64_t number = ++runs_;
    statements_->run.bind(1, number).bind(2, one_case).bind(3, run.test).bind(4, run.seed);
    statements_->run.bind(5, run.verdict).bind(6, run.duration).bind(7, run.steps);
    statements_->run.bind(8, run.state_hash).run();
    for (const Metric& metric : run.metrics) {
      statements_->metric.bind(1, number).bind(2, metric.id).bind(3, metric.value);
      statements_->metric.bind(4, metric.unit).bind(5, metric.warn).bind(6, metric.fail);
      statements_->metric.bind(7, metric.verdict).run();
    }
  }

  Connection database_;
  std::unique_ptr<Statements> statements_;
  std::uint64_t totals_[2] = {0, 0};
  std::int64_t models_ = 0;
  std::int64_t findings_ = 0;
  std::int64_t meshes_ = 0;
  std::int64_t cases_ = 0;
  std::int64_t runs_ = 0;
};

Writer::Writer(const std::string& path)
    : file_(std::make_unique<TemporaryFile>(path)),
      tables_(std::make_unique<Tables>(file_->path())) {}

Writer::~Writer() = default;

void Writer::add(const Record& record) {
  std::visit([this](const auto& each) { tables_->add(each); }, record);
}

void Writer::finish() {
  tables_->finish();
  tables_.reset();
  file_->rename();
}

std::string sqlite_version() { return sqlite3_libversion(); }

}  // namespace rigor::results
