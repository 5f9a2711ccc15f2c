// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats that `rigor validate` prints.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/report/terminal/color.h>
#include <rigor/report/validation.h>

namespace rigor::tool {

/// The first is the default; their numbers are those of `Target::format`.
std::vector<std::string_view> validation_formats();

std::string emit(std::size_t format, const report::Validation& validation, report::Color color);

}  // namespace rigor::tool
