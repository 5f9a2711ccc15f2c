// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with a mesh file, in words.

#pragma once

#include <string>

#include <rigor/mesh/fault.h>

namespace rigor::report {

/// "no triangles", "cannot be parsed: … (line 12)"; lower case, no full stop, without the file's name.
std::string fault_text(const mesh::Fault& fault);

}  // namespace rigor::report
