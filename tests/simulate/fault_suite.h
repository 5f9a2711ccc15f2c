// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The suite of testdata/simulate (its README.md says what is in it), for tests: its table, and a file of
// it made into a scene.

#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/simulate/scene/input.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

namespace rigor::test {

inline const std::string kSuiteFolder = std::string(RIGOR_TESTDATA) + "simulate/";

/// A row of suite.tsv.
struct SuiteCase {
  std::string file;  ///< "faults/sunk-5-cm.sdf"
  std::string test;
  std::string expected;              ///< "pass", "warn", "solver", "fail", "invalid": or worse
  std::vector<std::string> planted;  ///< scoped names of which one must be named
  std::string what;

  bool sane() const { return expected == "pass"; }
};

inline std::vector<std::string> suite_fields(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::stringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);) fields.push_back(field);
  return fields;
}

inline std::vector<SuiteCase> suite_cases() {
  std::vector<SuiteCase> cases;
  std::ifstream stream(kSuiteFolder + "suite.tsv");
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> fields = suite_fields(line, '\t');
    if (line.empty() || line[0] == '#' || fields.size() != 5) continue;
    cases.push_back({fields[0], fields[1], fields[2], suite_fields(fields[3], '|'), fields[4]});
  }
  return cases;
}

/// A file of the suite, read.
class SuiteModel {
 public:
  explicit SuiteModel(const std::string& file)
      : environment_(disk_, {}),
        workspace_(disk_, sources_),
        loaded_(read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                           workspace_.open(kSuiteFolder + file))),
        files_(loaded_, workspace_, environment_.resolver, environment_.workers) {}

  const model::Root& root() const { return loaded_.root; }
  const simulate::SceneInput& input() const { return files_.input(); }

 private:
  RealDisk disk_;
  Environment environment_;
  Sources sources_;
  read::Workspace workspace_;
  read::Loaded loaded_;
  simulate::SceneFiles files_;
};

}  // namespace rigor::test
