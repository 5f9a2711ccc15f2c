// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings for people: what is wrong, the lines it is about, and what to do.
//
//   error[joint-limit-inverted]: lower (1) is above upper (-1)
//     --> arm/model.sdf:12:12
//      |
//   12 |     <lower>1</lower>
//      |            ^
//      |
//      = in: arm/joint elbow
//      = why: No position is within the limits.
//      = unsafe fix: swap lower and upper
//
//   out += pretty(result.diagnostics, sources, Color::kAnsi);

#pragma once

#include <string>
#include <vector>

#include <rigor/report/places.h>
#include <rigor/report/terminal/color.h>
#include <rigor/rules/registry.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::report {

/// A block and an empty line for each finding; nothing when there are none.
std::string pretty(const Diagnostics& diagnostics, const Sources& sources, Color color);

/// The same, and at the first finding of each rule why it matters, and what to do where the finding itself
/// says nothing of that: the first sentences of the rule's page.
std::string pretty(const Diagnostics& diagnostics, const Sources& sources, Color color,
                   const rules::Registry& registry);

/// What stands below the headline of one finding, plain.
struct FindingDetails {
  std::string excerpt;             ///< its place, and the lines that it is about
  std::vector<std::string> notes;  ///< "in: arm/joint elbow", "help: swap them"
};
FindingDetails finding_details(const Diagnostic& diagnostic, Places& places);

}  // namespace rigor::report
