// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A line for each finding, as compilers write them, so that editors can jump to it:
//
//   path:line:col: severity: message [rule-name]
//
// Line and column are left out where a finding stands in no text.

#pragma once

#include <string>

#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::report {

std::string concise(const Diagnostics& diagnostics, const Sources& sources);

}  // namespace rigor::report
