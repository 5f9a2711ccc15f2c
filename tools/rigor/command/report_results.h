// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor report results.sqlite -o FOLDER/`.

#pragma once

#include <string>
#include <vector>

namespace rigor::tool {

/// Whether a report is asked of a database. A UsageError when of a database and something else.
bool names_results(const std::vector<std::string>& paths);

/// The exit code: 0, whatever the database holds. A UsageError when `out` is no folder or the file no database of results.
int report_results(const std::string& database, const std::string& out);

}  // namespace rigor::tool
