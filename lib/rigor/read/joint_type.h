// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Joint types by name, in any letter case, as libsdformat reads them.

#pragma once

#include <string_view>

#include <rigor/model/model.h>

namespace rigor::read {

/// kUnknown for a name that neither SDF nor URDF has.
model::JointType joint_type(std::string_view name);

}  // namespace rigor::read
