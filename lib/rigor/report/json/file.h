// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A file that was checked as JSON, the same in every report.

#pragma once

#include <rigor/report/json/values.h>
#include <rigor/rules/validate.h>

namespace rigor::report {

/// {"path": …, "kind": "sdf", "version": "1.9", "models": 1, "links": 3, "joints": 2}
Json file_json(const rules::FileSummary& file);

}  // namespace rigor::report
