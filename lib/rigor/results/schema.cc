// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/schema.h>

namespace rigor::results {

std::string_view tables() {
  return R"(
CREATE TABLE commands(
  command TEXT PRIMARY KEY,
  cases INTEGER NOT NULL
) WITHOUT ROWID;
CREATE TABLE models(
  id INTEGER PRIMARY KEY,
  path TEXT NOT NULL UNIQUE,
  kind TEXT,
  version TEXT,
  models INTEGER,
  links INTEGER,
  joints INTEGER,
  errors INTEGER NOT NULL,
  warnings INTEGER NOT NULL,
  infos INTEGER NOT NULL,
  verdict TEXT,
  worst INTEGER NOT NULL
);
CREATE TABLE skipped(
  model_id INTEGER NOT NULL REFERENCES models(id),
  case_id INTEGER REFERENCES cases(id),
  what TEXT NOT NULL
);
CREATE TABLE rules(
  rule TEXT PRIMARY KEY,
  category TEXT NOT NULL
) WITHOUT ROWID;
CREATE TABLE findings(
  id INTEGER PRIMARY KEY,
  model_id INTEGER NOT NULL REFERENCES models(id),
  case_id INTEGER REFERENCES cases(id),
  rule TEXT NOT NULL REFERENCES rules(rule),
  severity TEXT NOT NULL,
  places INTEGER NOT NULL
);
CREATE TABLE places(
  finding_id INTEGER NOT NULL REFERENCES findings(id),
  number INTEGER NOT NULL,
  path TEXT NOT NULL,
  line INTEGER,
  "column" INTEGER,
  end_line INTEGER,
  end_column INTEGER,
  subject TEXT NOT NULL,
  message TEXT NOT NULL,
  PRIMARY KEY(finding_id, number)
) WITHOUT ROWID;
CREATE TABLE meshes(
  id INTEGER PRIMARY KEY,
  digest TEXT NOT NULL UNIQUE,
  bytes INTEGER NOT NULL,
  triangles INTEGER,
  min_x REAL,
  min_y REAL,
  min_z REAL,
  max_x REAL,
  max_y REAL,
  max_z REAL
);
CREATE TABLE model_meshes(
  model_id INTEGER NOT NULL REFERENCES models(id),
  path TEXT NOT NULL,
  mesh_id INTEGER NOT NULL REFERENCES meshes(id),
  PRIMARY KEY(model_id, path)
) WITHOUT ROWID;
CREATE TABLE cases(
  id INTEGER PRIMARY KEY,
  model_id INTEGER NOT NULL REFERENCES models(id),
  name TEXT NOT NULL,
  verdict TEXT NOT NULL
);
CREATE TABLE runs(
  id INTEGER PRIMARY KEY,
  case_id INTEGER NOT NULL REFERENCES cases(id),
  test TEXT NOT NULL,
  seed INTEGER NOT NULL,
  verdict TEXT NOT NULL,
  duration REAL,
  steps INTEGER NOT NULL,
  state_hash TEXT NOT NULL
);
CREATE TABLE metrics(
  run_id INTEGER NOT NULL REFERENCES runs(id),
  metric TEXT NOT NULL,
  value REAL,
  unit TEXT NOT NULL,
  warn REAL,
  fail REAL,
  verdict TEXT NOT NULL,
  PRIMARY KEY(run_id, metric)
) WITHOUT ROWID;
)";
}

std::string_view indexes() {
  return R"(
CREATE INDEX models_by_worst ON models(worst DESC, errors DESC, path);
CREATE INDEX findings_by_model ON findings(model_id);
CREATE INDEX findings_by_rule ON findings(rule, severity);
CREATE INDEX skipped_by_model ON skipped(model_id);
CREATE INDEX model_meshes_by_mesh ON model_meshes(mesh_id);
CREATE INDEX cases_by_model ON cases(model_id);
CREATE INDEX runs_by_case ON runs(case_id);
)";
}

}  // namespace rigor::results
