// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/bullet_urdf.h>

#include <string_view>
#include <utility>

namespace rigor::convert {

bool is_spherical(const model::Joint& joint) {
  return joint.type == model::JointType::kUnknown && joint.type_name.value == "spherical";
}

std::string missing_entries(const model::Inertial& inertial) {
  const std::pair<std::string_view, const model::Field<double>*> entries[] = {
      {"ixx", &inertial.ixx}, {"ixy", &inertial.ixy}, {"ixz", &inertial.ixz},
      {"iyy", &inertial.iyy}, {"iyz", &inertial.iyz}, {"izz", &inertial.izz}};
  std::string names;
  for (const auto& [name, entry] : entries) {
    if (!entry->written) names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

bool has_incomplete_inertia(const model::Link& link) {
  const model::Inertial& inertial = link.inertial;
  return inertial.written && inertial.mass.written && inertial.mass.value != 0 &&
         inertial.tensor_written && !missing_entries(inertial).empty();
}

}  // namespace rigor::convert
