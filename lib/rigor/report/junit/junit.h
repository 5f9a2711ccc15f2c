// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A check as a test report: a suite for each file, a case for each finding, and one that passed for a file
// without findings. Errors and warnings are failures, what kept a file from being read is an error, an
// info finding passes and says what it is, and a file that was left out is skipped.

#pragma once

#include <string>

#include <rigor/report/validation.h>

namespace rigor::report {

/// Suites are sorted by path. Without durations, so that the same check gives the same bytes.
std::string junit(const Validation& validation);

}  // namespace rigor::report
