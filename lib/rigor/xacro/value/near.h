// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean": the name that is spelled most like another one.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor::xacro {

/// Of the candidates the one with the fewest letters added, dropped, changed or swapped, a third of the name's
/// at most; empty when none is as near.
std::string nearest_name(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace rigor::xacro
