// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

bool is_named(std::string_view scoped, std::string_view written) {
  if (!scoped.ends_with(written)) return false;
  const std::string_view scope = scoped.substr(0, scoped.size() - written.size());
  return scope.empty() || scope.ends_with("::");
}

double moving_mass(const Scene& scene) {
  double sum = 0;
  for (const SceneBody& body : scene.bodies) {
    if (!body.kinematic) sum += body.mass.mass;
  }
  return sum;
}

}  // namespace rigor::simulate
