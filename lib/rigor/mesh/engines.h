// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whose geometry is at work here, for `rigor --version`.
//
//   say("Qhull " + mesh::qhull_version());

#pragma once

#include <string>

namespace rigor::mesh {

/// "2020.2"
std::string qhull_version();

/// "0.18"
std::string meshoptimizer_version();

}  // namespace rigor::mesh
