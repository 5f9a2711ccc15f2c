// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of models that opens a report, and what they come to together.
//
//   page += team_report_summary(rows) + team_report_table(rows);

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/simulate/metric/metric.h>

namespace rigor::report {

struct TriangleCount {
  std::uint64_t triangles = 0;
  std::size_t unread = 0;   ///< meshes whose triangles nobody knows
  bool over_model = false;  ///< more than the budget of a model
  bool over_mesh = false;   ///< one of the meshes has more than that of a mesh

  bool over() const { return over_model || over_mesh; }
};

struct TeamReportRow {
  std::string link;  ///< to the model's section
  std::string name;
  std::string path;
  std::string image;  ///< its thumbnail as HTML; empty when there is none
  std::string format;
  std::size_t links = 0;
  std::size_t joints = 0;
  double mass = 0;  ///< kg
  TriangleCount visual;
  TriangleCount collision;
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::optional<simulate::Verdict> verdict;
  std::string no_verdict;  ///< in its place: "nothing moves"
};

/// Counts of models, findings and verdicts.
std::string team_report_summary(const std::vector<TeamReportRow>& rows);

std::string team_report_table(const std::vector<TeamReportRow>& rows);

}  // namespace rigor::report
