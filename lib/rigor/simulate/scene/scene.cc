// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/scene.h>

#include <algorithm>

namespace rigor::simulate {
namespace {

/// m/(s·N) of a mass of 1 kg and a step of 1 s: what bears all of the weight gives way by what gravity adds in a step,
/// 10 mm/s of the 100 mm/s that are corrected at most. So it comes to rest at a twentieth of a millimeter whatever the
/// weight. Up to 100 kg the profile's is less.
constexpr double kSoftness = 1;

/// (m/s)/N: the exact solver ends in an assertion with less where contacts are redundant.
constexpr double kStiffest = 1e-9;

}  // namespace

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

double softest_cfm(const Scene& scene) {
  return std::max(kStiffest, kSoftness * scene.solver.step / moving_mass(scene));
}

}  // namespace rigor::simulate
