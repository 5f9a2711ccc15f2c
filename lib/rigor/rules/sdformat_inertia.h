// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether libsdformat takes a mass and a tensor: the test of `MassMatrix3::IsValid` in its mathematics
// library (Ignition Math 6), step by step, since rounding decides of thin plates.
//
//   if (!sdformat_takes(inertial.mass.value, mass::tensor(inertial))) refuse();

#pragma once

#include <rigor/mass/mass_properties.h>

namespace rigor::rules {

/// Mass in kg, tensor in kg·m². The mass may be infinite; the tensor may not.
bool sdformat_takes(double mass, const mass::Inertia& tensor);

}  // namespace rigor::rules
