// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/resolve.h>

#include <algorithm>
#include <array>

namespace rigor::mass {
namespace {

/// urdfdom drops an inertial from which a number is missing.
bool complete(const model::Inertial& i) {
  const std::array parts{&i.mass, &i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz};
  return std::all_of(parts.begin(), parts.end(), [](const auto* part) { return part->written; });
}

}  // namespace

Inertia tensor(const model::Inertial& i) {
  return {i.ixx.value, i.ixy.value, i.ixz.value, i.iyy.value, i.iyz.value, i.izz.value};
}

MassProperties resolve(const model::Root& root, model::Id<model::Link> id) {
  constexpr Inertia kIdentity{1, 0, 0, 1, 0, 1};
  const model::Inertial& inertial = root[id].inertial;
  const bool urdf = root[root[id].model].format == model::Format::kUrdf;
  if (urdf && !complete(inertial)) return {};
  if (!inertial.written) return {1, {}, kIdentity};
  const MassProperties in_C{
      inertial.mass.value, {}, inertial.tensor_written ? tensor(inertial) : kIdentity};
  return transformed(inertial.pose.pose.value, in_C);
}

}  // namespace rigor::mass
