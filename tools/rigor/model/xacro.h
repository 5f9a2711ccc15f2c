// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Has the installed program `xacro` expand a file, within limits of time, memory and output.
//
//   options.expand = expand_xacro;

#pragma once

#include <string>

#include <rigor/read/expansion.h>

namespace rigor::tool {

read::Expansion expand_xacro(const std::string& path);

}  // namespace rigor::tool
