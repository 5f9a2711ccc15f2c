// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What xacro would have replaced, had it been run.

#pragma once

#include <string_view>

namespace rigor::rules {

/// Whether a value still has xacro's `${…}` or `$(…)` in it.
inline bool has_xacro(std::string_view value) {
  return value.find("${") != std::string_view::npos || value.find("$(") != std::string_view::npos;
}

}  // namespace rigor::rules
