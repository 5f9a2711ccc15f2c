// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings in SARIF 2.1.0 (OASIS), as GitHub's code scanning and editors read it: every rule with its help,
// every finding with its place, what is related, and the fix.
//
//   std::fputs(sarif({result, sources, environment.registry, folders, exit_code}).c_str(), stdout);

#pragma once

#include <string>

#include <rigor/report/validation.h>

namespace rigor::report {

/// Columns count code points. Places are relative to the top of the repository, `SRCROOT`; nothing says where on
/// the machine that is, but what a message itself says.
std::string sarif(const Validation& validation);

}  // namespace rigor::report
