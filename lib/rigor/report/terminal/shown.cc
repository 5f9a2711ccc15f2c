// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/shown.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/places.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/validation.h>

namespace rigor::report {
namespace {

struct RuleRow {
  const Diagnostic* first;
  std::size_t findings = 0;
  std::size_t places = 0;
};

std::vector<RuleRow> rule_rows(const Diagnostics& findings) {
  std::vector<RuleRow> rows;
  for (const Diagnostic& finding : findings.list()) {
    const auto same = [&finding](const RuleRow& row) {
      return row.first->rule == finding.rule && row.first->severity == finding.severity;
    };
    auto row = std::find_if(rows.begin(), rows.end(), same);
    if (row == rows.end()) row = rows.insert(rows.end(), {&finding});
    row->findings += finding.count;
    row->places += finding.count + finding.others.size();
  }
  std::stable_sort(rows.begin(), rows.end(), [](const RuleRow& a, const RuleRow& b) {
    if (a.first->severity != b.first->severity) return a.first->severity < b.first->severity;
    return a.places > b.places;
  });
  return rows;
}

}  // namespace

Diagnostics shown(const Diagnostics& findings, Severity least) {
  Diagnostics list;
  for (const Diagnostic& finding : findings.list()) {
    if (finding.severity <= least) list.add(finding);
  }
  return list;
}

std::string not_shown(const Diagnostics& findings, Severity least) {
  std::size_t warnings = 0;
  std::size_t notes = 0;
  std::set<std::string_view> rules;
  for (const Diagnostic& finding : findings.list()) {
    if (finding.severity <= least) continue;
    (finding.severity == Severity::kWarning ? warnings : notes) += finding.count;
    rules.insert(finding.rule);
  }
  if (rules.empty()) return {};
  std::string what = warnings > 0 ? counted(warnings, "warning") : "";
  if (notes > 0) what += (what.empty() ? "" : " and ") + counted(notes, "note");
  return fmt::format("{} in {}; --show {}", what, counted(rules.size(), "rule"),
                     notes > 0 ? "info" : "warning");
}

std::string rule_table(const Diagnostics& findings, const Sources& sources) {
  const std::vector<RuleRow> rows = rule_rows(findings);
  if (rows.empty()) return {};
  std::size_t width = std::string_view("rule").size();
  for (const RuleRow& row : rows) width = std::max(width, row.first->rule.size());
  std::string out = fmt::format("{:<8} {:<{}} {:>8} {:>8}  {}\n", "severity", "rule", width,
                                "findings", "places", "first place");
  Places places(sources);
  for (const RuleRow& row : rows) {
    out += fmt::format("{:<8} {:<{}} {:>8} {:>8}  {}\n", to_string(row.first->severity),
                       row.first->rule, width, row.findings, row.places,
                       place_text(*row.first, places));
  }
  return out;
}

}  // namespace rigor::report
