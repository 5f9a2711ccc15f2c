// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A line for each file that was checked, so that the parts of a sharded run can be joined:
//
//   {"case": {"index": 0, "of": 2, "id": "arm/model.sdf"}, "path": "arm/model.sdf", "kind": "sdf",
//    "version": "1.9", "models": 1, "links": 3, "joints": 2, "not_looked_at": [], "diagnostics": […]}
//
// `rigor merge` puts them in the order of their cases.

#pragma once

#include <string>

#include <rigor/report/validation.h>

namespace rigor::report {

std::string jsonl(const Validation& validation);

}  // namespace rigor::report
