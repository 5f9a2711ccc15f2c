// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the reference has without a module's name before it: `pi`, `sin`, `len`, `python`.

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

std::optional<Value> global_builtin(std::string_view name);

std::vector<std::string_view> global_builtin_names();

}  // namespace rigor::xacro
