// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A line for each file that was checked, so that the parts of a sharded run can be joined:
//
//   {"case": {"index": 0, "of": 2, "id": "arm/model.sdf"}, "path": "arm/model.sdf", "kind": "sdf",
//    "version": "1.9", "models": 1, "links": 3, "joints": 2, "not_looked_at": [],
//    "meshes": [{"path": "arm/hull.stl", "digest": "9f…", "bytes": 684, "triangles": 12,
//                "extents": {"min": [-1, -1, -1], "max": [1, 1, 1]}}], "diagnostics": […]}
//
// `meshes` are listed when `ValidateOptions::mesh_listing` says so. The `extents` are m, or the file's own unit where its
// format has none; they are null, as `triangles` is, where the file could not be read. `rigor merge` puts them in the order of their cases.

#pragma once

#include <string>

#include <rigor/report/validation.h>

namespace rigor::report {

std::string jsonl(const Validation& validation);

}  // namespace rigor::report
