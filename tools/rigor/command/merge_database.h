// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor merge FILE.jsonl... -o results.sqlite`.

#pragma once

#include <string>
#include <vector>

namespace rigor::tool {

/// The exit code. Files of `validate` and of `simulate` may be mixed; each run is complete, or nothing is written.
int merge_database(const std::vector<std::string>& files, const std::string& out);

}  // namespace rigor::tool
