// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/srdf.h>

#include <utility>

#include <fmt/core.h>

#include <rigor/lsp/answer/name_lookup.h>
#include <rigor/read/srdf/srdf.h>
#include <rigor/robot/semantic/srdf_check.h>
#include <rigor/rules/reference/srdf_facts.h>

namespace rigor::lsp {

std::vector<CompanionFinding> srdf_findings(State& state, OpenDocument& document) {
  const xml::Document& written = document.analysis(state.environment()).written();
  const auto root = written.root();
  if (!root || root->name() != "robot") return {};
  const read::Srdf srdf = read::read_srdf(*root);
  if (srdf.robot.where.nowhere())
    return {{root->name_span(), Severity::kError, "the robot has no name"}};
  const std::string& robot = srdf.robot.text;
  const std::vector<const robot::SemanticTarget*> robots =
      state.robots_named(robot, [&] { return workspace_files(state, document); });
  if (robots.empty()) {
    return {{srdf.robot.where, Severity::kInfo,
             fmt::format("no robot in the workspace is named '{}': names are not checked", robot)}};
  }
  std::vector<CompanionFinding> found;
  for (const robot::SrdfFact& fact : robot::check_srdf(srdf, robots)) {
    const bool works = fact.kind == robot::SrdfFactKind::kPairsChecked;
    found.push_back(
        {fact.where, works ? Severity::kWarning : Severity::kError, rules::describe(fact, robot)});
  }
  return found;
}

}  // namespace rigor::lsp
