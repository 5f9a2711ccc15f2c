// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which links' inertia matters, and which tensors stand in the file whole.

#pragma once

#include <cmath>

#include <rigor/mass/resolve.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Whether the simulator integrates the link's motion: it is neither static nor kinematic.
inline bool is_dynamic(const model::Link& link, const Context& context) {
  return !link.kinematic.value && !model::is_static(context.root(), link.model);
}

/// Whether the file gives the tensor, so that there is something to judge. Entries that are missing
/// or cannot be read are reported by the schema's rules; off-diagonal ones default to zero in SDF.
inline bool has_tensor(const model::Link& link, const Context& context) {
  const model::Inertial& i = link.inertial;
  if (!i.tensor_written || mass::is_automatic(link)) return false;
  if (!i.ixx.written || !i.iyy.written || !i.izz.written) return false;
  return context.is_sdf() || (i.ixy.written && i.ixz.written && i.iyz.written);
}

/// Whether the tensor is zero but for the rounding of who computed it: no dust has such moments.
inline bool is_rounding_of_zero(const mass::Verdict& verdict) {
  constexpr double kNothing = 1e-30;  // kg·m²
  return std::abs(verdict.principal[0]) < kNothing && std::abs(verdict.principal[2]) < kNothing;
}

}  // namespace rigor::rules
