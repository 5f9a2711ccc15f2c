// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What became of a template that a program was to expand, as `xacro` does.
//
//   const Expansion expansion = expand("robot.urdf.xacro");
//   if (!expansion.text) report(expansion.problem, expansion.why);

#pragma once

#include <functional>
#include <optional>
#include <string>

#include <rigor/read/fact.h>

namespace rigor::read {

struct Expansion {
  std::optional<std::string> text;
  FactKind problem = FactKind::kXacroFailed;  ///< why there is none
  std::string why;                            ///< in the program's own words
};

/// Expands the file at a path.
using Expand = std::function<Expansion(const std::string& path)>;

}  // namespace rigor::read
