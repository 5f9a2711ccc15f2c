// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/resolve.h>

#include <algorithm>
#include <array>
#include <optional>

#include <rigor/mass/geom_mass.h>

namespace rigor::mass {
namespace {

/// urdfdom drops an inertial from which a number is missing.
bool complete(const model::Inertial& i) {
  const std::array parts{&i.mass, &i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz};
  return std::all_of(parts.begin(), parts.end(), [](const auto* part) { return part->written; });
}

/// As libsdformat computes it; nothing when it cannot.
std::optional<MassProperties> automatic(const model::Root& root, const model::Frames& frames,
                                        model::Id<model::Link> id, const FindMesh& find_mesh) {
  const LinkBody solids = link_body(root, frames, id, From::kCollisions, find_mesh);
  if (!solids.complete()) return std::nullopt;
  const MassProperties body = of_own_densities(solids);
  const model::Field<double>& mass = root[id].inertial.mass;
  return mass.written ? with_mass(body, mass.value) : body;
}

Taken taken(const model::Inertial& inertial, model::Format format) {
  if (format == model::Format::kUrdf) {
    return complete(inertial) ? Taken::kWritten : Taken::kNothing;
  }
  if (!inertial.written) return Taken::kDefaults;
  return inertial.tensor_written ? Taken::kWritten : Taken::kIdentity;
}

}  // namespace

Inertia tensor(const model::Inertial& i) {
  return {i.ixx.value, i.ixy.value, i.ixz.value, i.iyy.value, i.iyz.value, i.izz.value};
}

MassProperties resolve(const model::Root& root, model::Id<model::Link> id) {
  constexpr Inertia kIdentity{1, 0, 0, 1, 0, 1};
  const model::Inertial& inertial = root[id].inertial;
  if (root[root[id].model].format == model::Format::kMjcf) {
    return geom_mass(root, id, {}).value_or(MassProperties{});
  }
  switch (taken(inertial, root[root[id].model].format)) {
    case Taken::kNothing: return {};
    case Taken::kDefaults: return {1, {}, kIdentity};
    default: break;
  }
  const MassProperties in_C{
      inertial.mass.value, {}, inertial.tensor_written ? tensor(inertial) : kIdentity};
  return transformed(inertial.pose.pose.value, in_C);
}

Resolved resolve(const model::Root& root, const model::Frames& frames, model::Id<model::Link> id,
                 const FindMesh& find_mesh) {
  const model::Link& link = root[id];
  if (root[link.model].format == model::Format::kMjcf) {
    const auto body = geom_mass(root, id, find_mesh);
    if (!body) return {{}, Taken::kAutomaticUnknown};
    return {*body, is_automatic(link) ? Taken::kAutomatic : Taken::kWritten};
  }
  if (!is_automatic(link)) {
    return {resolve(root, id), taken(link.inertial, root[link.model].format)};
  }
  if (const auto body = automatic(root, frames, id, find_mesh)) return {*body, Taken::kAutomatic};
  return {{1, {}, {1, 0, 0, 1, 0, 1}}, Taken::kAutomaticUnknown};
}

}  // namespace rigor::mass
