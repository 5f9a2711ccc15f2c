// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers and bodies as JSON, for the reports that print it.

#pragma once

#include <cmath>

#include <nlohmann/json.hpp>

#include <rigor/mass/mass_properties.h>

namespace rigor::report {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: null instead. And no negative zero.
inline Json finite(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value == 0 ? 0.0 : value;
}

inline Json vector_of(const model::Vector3& v) {
  return Json::array({finite(v.x), finite(v.y), finite(v.z)});
}

inline Json tensor_of(const mass::Inertia& i) {
  return {{"ixx", finite(i.ixx)}, {"ixy", finite(i.ixy)}, {"ixz", finite(i.ixz)},
          {"iyy", finite(i.iyy)}, {"iyz", finite(i.iyz)}, {"izz", finite(i.izz)}};
}

}  // namespace rigor::report
