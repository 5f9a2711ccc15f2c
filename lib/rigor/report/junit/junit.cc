// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/junit/junit.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/report/junit/document.h>
#include <rigor/report/terminal/excerpt.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using Outcome = JunitCase::Outcome;

/// Readers make a tree of the parts between dots.
std::string junit_class(std::string path) {
  std::replace(path.begin(), path.end(), '/', '.');
  return path;
}

std::string junit_details(const Diagnostic& diagnostic, Places& places) {
  std::string text = concise_line(diagnostic, places) + '\n';
  if (!diagnostic.where.nowhere()) {
    std::vector<Mark> marks{{diagnostic.where, '^', {}}};
    for (const Label& label : diagnostic.related) {
      if (label.where.source == diagnostic.where.source) {
        marks.push_back({label.where, '-', label.message});
      }
    }
    text += excerpt(marks, places, {gutter_width(marks, places), Color::kPlain, Paint::kError});
  }
  for (const std::string& line : origin_lines(diagnostic, places)) text += line + '\n';
  if (!diagnostic.help.empty()) text += "help: " + printable(diagnostic.help) + '\n';
  return text;
}

/// What does not fail the run passes here, and says what it found in its output.
JunitCase finding_case(const Diagnostic& diagnostic, const std::string& path, bool fails,
                       Places& places) {
  JunitCase one{
      .class_name = junit_class(path), .name = std::string(diagnostic.rule), .file = path};
  if (!diagnostic.where.nowhere()) one.line = places.begin(diagnostic.where).line;
  if (!fails) {
    one.output = junit_details(diagnostic, places);
    return one;
  }
  one.outcome = keeps_from_reading(diagnostic) ? Outcome::kError : Outcome::kFailure;
  one.message = printable(diagnostic.message);
  one.type = to_string(diagnostic.severity);
  one.details = junit_details(diagnostic, places);
  return one;
}

JunitSuite suite_of(const rules::FileSummary& file, const Validation& validation, Places& places) {
  const std::string path = printable(project_path(validation, file.path));
  const Severity fail_on = validation.fail_on ? validation.fail_on(file.path) : Severity::kError;
  JunitSuite suite{path, path, {}};
  for (std::size_t i = file.first_finding; i < file.end_finding; ++i) {
    const Diagnostic& finding = validation.result.diagnostics.list()[i];
    const bool fails = finding.severity <= fail_on;
    suite.cases.push_back(finding_case(finding, path, fails, places));
  }
  if (suite.cases.empty()) {
    suite.cases.push_back(
        {.class_name = junit_class(path), .name = std::string(kToolName), .file = path});
  }
  return suite;
}

}  // namespace

std::string junit(const Validation& ungrouped) {
  const rules::ValidateResult result = grouped(ungrouped.result, GroupScope::kFile);
  const Validation validation{result,
                              ungrouped.sources,
                              ungrouped.registry,
                              ungrouped.folders,
                              ungrouped.exit_code,
                              ungrouped.fail_on};
  Places places(validation.sources);
  std::vector<JunitSuite> suites;
  std::set<std::string_view> checked;
  for (const rules::FileSummary& file : validation.result.files) {
    checked.insert(file.path);
    suites.push_back(suite_of(file, validation, places));
  }
  for (const rules::NotLookedAt& item : validation.result.not_looked_at) {
    if (checked.contains(item.path)) continue;
    const std::string path = printable(project_path(validation, item.path));
    suites.push_back({path,
                      path,
                      {{.class_name = junit_class(path),
                        .name = std::string(kToolName),
                        .file = path,
                        .outcome = Outcome::kSkipped,
                        .message = "skipped: " + printable(item.what)}}});
  }
  std::stable_sort(suites.begin(), suites.end(),
                   [](const JunitSuite& a, const JunitSuite& b) { return a.name < b.name; });
  return junit_document(kToolName, std::move(suites));
}

}  // namespace rigor::report
