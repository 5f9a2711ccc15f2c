// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a run came to, in a line for stderr.
//
//   "3 files checked: 1 error, 2 warnings; 1 include skipped"
//   "12 files checked, no problems"

#pragma once

#include <string>

#include <rigor/rules/validate.h>

namespace rigor::report {

/// Without a line break.
std::string summary(const rules::ValidateResult& result);
/// The same of findings that are not grouped yet, as if they were.
std::string summary_of_groups(const rules::ValidateResult& result);

/// A line for each file that was met and not checked, such as a template, and why; the first few of
/// many. Includes that were not followed are findings of their own.
std::string left_out(const rules::ValidateResult& result);

/// ": 1 error, 2 warnings", or ", no problems"; once grouped with their places: ": 1 error at 40 places".
std::string findings(const Diagnostics& diagnostics);

/// "1 link", "1,204 links"; the plural where it is irregular: "2 vertices".
std::string counted(std::size_t count, std::string_view noun, std::string_view plural = {});

}  // namespace rigor::report
