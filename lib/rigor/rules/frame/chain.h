// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The frames of a cycle, in words.

#pragma once

#include <string>

#include <rigor/model/frames.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// "'a' -> 'b' -> 'a'".
inline std::string chain(const model::FrameProblem& problem) {
  std::string text;
  for (const std::string& member : problem.members) {
    if (!text.empty()) text += " -> ";
    text += "'" + member + "'";
  }
  return text;
}

/// Reports what the members do to each other, around the cycle.
inline void report_cycle(const model::FrameProblem& problem, const std::string& what,
                         Context& context) {
  context.report({.where = problem.where,
                  .message = what + " in a cycle: " + chain(problem),
                  .subject = problem.subject});
}

}  // namespace rigor::rules
