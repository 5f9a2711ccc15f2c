// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A check as a test report: a suite for each file, a case for each finding, and one that passed for a file
// without findings. Findings of one rule and cause in a file are one case. What is as severe as --fail-on says (an
// error where that is never) is a failure, or an error where it kept the file from being read; any other finding passes, with its text as
// output. A file that was left out is skipped.

#pragma once

#include <string>

#include <rigor/report/validation.h>

namespace rigor::report {

/// Suites are sorted by path. Without durations, so that the same check gives the same bytes.
std::string junit(const Validation& validation);

}  // namespace rigor::report
