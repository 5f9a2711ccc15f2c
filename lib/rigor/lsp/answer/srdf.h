// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SRDF held against the robot that it is about.

#pragma once

#include <string>
#include <vector>

#include <rigor/lsp/session/state.h>
#include <rigor/text/diagnostic.h>

namespace rigor::lsp {

struct CompanionFinding {
  Span where;
  Severity severity = Severity::kError;
  std::string message;
};

/// Names that no robot of the workspace with the SRDF's name has, groups that are not defined, states outside the
/// limits of their joints. One finding only when there is no such robot.
std::vector<CompanionFinding> srdf_findings(State& state, OpenDocument& document);

}  // namespace rigor::lsp
