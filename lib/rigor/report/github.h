// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings as GitHub's workflow commands, which become annotations of the changed lines:
//
//   ::error title=rigor (axis-zero),file=arm/model.sdf,line=12,endLine=12,col=7,endColumn=12::arm/model.sdf:12:7: …
//
// Of a step GitHub shows the first ten of each kind and says nothing of the others, so the most severe come
// first, and a notice says how many are in the log only.

#pragma once

#include <string>

#include <rigor/report/validation.h>

namespace rigor::report {

std::string github(const Validation& validation);

/// All findings as a table in Markdown, for the page of the run: what $GITHUB_STEP_SUMMARY names. GitHub
/// takes a mebibyte and refuses anything longer as a whole, so what does not fit is counted.
std::string github_summary(const Validation& validation);

}  // namespace rigor::report
