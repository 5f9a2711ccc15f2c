// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats that `rigor validate` prints.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/report/terminal/color.h>
#include <rigor/report/validation.h>

namespace rigor::tool {

/// The first is the default; their numbers are those of `Target::format`.
std::vector<std::string_view> validation_formats();

/// What is listed on a terminal.
struct TerminalView {
  enum class Form : std::uint8_t { kList, kTable };
  Severity least = Severity::kWarning;
  Form form = Form::kList;
};

/// Whether a format is for people, who are shown what a `TerminalView` says; the others are complete.
bool is_for_people(std::size_t format);

std::string emit(std::size_t format, const report::Validation& validation, report::Color color,
                 TerminalView view);

}  // namespace rigor::tool
