// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits shown as a unified diff, as `patch` and `git apply` take it.
//
//   std::string shown = unified_diff("robot.sdf", bytes, edits);

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/edit.h>

namespace rigor {

/// With three lines of context; empty when the edits change nothing or cannot be applied.
std::string unified_diff(std::string_view path, std::string_view bytes, std::vector<Edit> edits);

}  // namespace rigor
