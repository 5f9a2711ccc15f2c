// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings as GitLab's code quality report, which a merge request shows: a list of
//
//   {"description": "axis-zero: axis is 0 0 0: it has no direction", "check_name": "axis-zero",
//    "fingerprint": "…", "severity": "major", "location": {"path": "arm/model.sdf", "lines": {"begin": 12}}}
//
// The empty list when there are none: without a file GitLab takes it that nothing was checked.

#pragma once

#include <string>

#include <rigor/report/validation.h>

namespace rigor::report {

std::string gitlab(const Validation& validation);

}  // namespace rigor::report
