// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A tensor that is about the link's origin, moved to the center of mass, and the edits that write one.
//
//   const mass::Inertia about_com = without_mass_at_center(link.inertial);
//   if (mass::judge(mass, about_com).possible()) return write_tensor(link.inertial, about_com);

#pragma once

#include <algorithm>
#include <cmath>

#include <rigor/mass/resolve.h>
#include <rigor/mass/shapes.h>
#include <rigor/rules/context.h>
#include <rigor/write/numbers.h>

namespace rigor::rules {

/// What is written, taken to be about the link's origin, about the center of mass; in the same axes.
inline mass::Inertia without_mass_at_center(const model::Inertial& inertial) {
  const model::Pose& X_LC = inertial.pose.pose.value;
  return mass::tensor(inertial) -
         mass::rotated(model::conjugate(X_LC.rotation),
                       mass::point_inertia(inertial.mass.value, X_LC.translation));
}

inline Fix write_tensor(const model::Inertial& inertial, const mass::Inertia& tensor) {
  Fix fix{"write the tensor about the center of mass", Applicability::kUnsafe, {}};
  const auto add = [&fix](const model::Field<double>& field, double value) {
    if (!field.written || field.value == value) return;
    const double size = std::max(std::abs(field.value), std::abs(value));
    fix.edits.push_back({field.span, write::joined({write::settled(value, field.value, size)})});
  };
  add(inertial.ixx, tensor.ixx);
  add(inertial.ixy, tensor.ixy);
  add(inertial.ixz, tensor.ixz);
  add(inertial.iyy, tensor.iyy);
  add(inertial.iyz, tensor.iyz);
  add(inertial.izz, tensor.izz);
  return fix;
}

}  // namespace rigor::rules
