// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The frames of a cycle, in words.

#pragma once

#include <string>

#include <rigor/model/frames.h>

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

}  // namespace rigor::rules
