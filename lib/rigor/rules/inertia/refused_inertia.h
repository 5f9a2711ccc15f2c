// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether libsdformat refuses a link's inertia; see compat.h.

#pragma once

#include <rigor/mass/resolve.h>
#include <rigor/rules/context.h>
#include <rigor/rules/sdformat_inertia.h>
#include <rigor/rules/sdformat_robot.h>

namespace rigor::rules {

/// Of a URDF what counts is the link of the model that this one becomes, or is lumped into.
inline bool refuses_inertia(const model::Link& link, Context& context) {
  const model::Root& root = context.root();
  if (context.is_sdf()) {
    constexpr mass::Inertia kIdentity{1, 0, 0, 1, 0, 1};
    const model::Inertial& i = link.inertial;
    return !sdformat_takes(i.mass.value, i.tensor_written ? mass::tensor(i) : kIdentity);
  }
  const SdformatRobot& robot = context.sdformat_robot();
  const auto& links = root.models.front().links;
  for (std::size_t i = 0; i < robot.parts.size(); ++i) {
    if (&root[links[i]] == &link) return robot.refuses_inertia(i);
  }
  return false;
}

}  // namespace rigor::rules
