// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which MuJoCo the engine is made for, for `rigor --version`. Nothing is opened for it.

#pragma once

#include <string>

namespace rigor::simulate {

/// "2.2.2"; empty in a build without MuJoCo's headers.
std::string mujoco_version();

}  // namespace rigor::simulate
