// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of numbers, "0 0  0.5" as in <pose> and xyz, whose white space means nothing to any reader.

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigor::author {

/// The numbers as they are written, with one space between them; nothing where a word is no decimal number.
std::optional<std::string> number_row(std::string_view text);

/// Whether the attribute holds a row of numbers in URDF and its xacro: xyz, rpy, rgba, size, scale.
bool is_row_attribute(std::string_view name);

}  // namespace rigor::author
