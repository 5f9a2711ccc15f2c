// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Mistakes in a tensor that the link's shapes give away: the tensor does not fit them as solids, and fits
// very well once the mistake is undone.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <rigor/mass/shapes.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>

namespace rigor::rules {

enum class TensorMistake : std::uint8_t {
  kNone,
  kAxesSwapped,      ///< the moments stand at each other's axes
  kProductsNegated,  ///< the products have the opposite sign
  kAboutLinkOrigin,  ///< it is about the link's origin, not the center of mass
  kTurned,  ///< it is along the link's axes, and the inertial's pose turns it away from them
};

struct MistakenTensor {
  TensorMistake mistake = TensorMistake::kNone;
  /// Where the moments that are written as ixx, iyy and izz belong; of swapped axes.
  std::array<std::size_t, 3> belongs{0, 1, 2};
};

namespace tensor_mistake {

// Shares of the moments' sum. A tensor that is off by more than kOff does not fit; one that is off by less
// than kFits, and kBetter times less than before, fits: no chance likeness is so good in all six entries.
inline constexpr double kOff = 0.05;
inline constexpr double kFits = 0.03;
inline constexpr double kBetter = 4;

inline double difference(const mass::Inertia& tensor, const mass::Inertia& solid) {
  const mass::Inertia d = tensor - solid;
  double most = 0;
  for (const double entry : {d.ixx, d.ixy, d.ixz, d.iyy, d.iyz, d.izz}) {
    most = std::max(most, std::abs(entry));
  }
  return most / mass::trace(solid);
}

inline mass::Inertia with_products_negated(mass::Inertia tensor) {
  tensor.ixy = -tensor.ixy;
  tensor.ixz = -tensor.ixz;
  tensor.iyz = -tensor.iyz;
  return tensor;
}

/// The moments put where they belong; products, which are small then, dropped.
inline mass::Inertia permuted(const mass::Inertia& tensor,
                              const std::array<std::size_t, 3>& belongs) {
  std::array<double, 3> moments{};
  moments[belongs[0]] = tensor.ixx;
  moments[belongs[1]] = tensor.iyy;
  moments[belongs[2]] = tensor.izz;
  return {moments[0], 0, 0, moments[1], 0, moments[2]};
}

inline bool has_products(const mass::Inertia& t) {
  return std::max({std::abs(t.ixy), std::abs(t.ixz), std::abs(t.iyz)}) > kFits / 2 * mass::trace(t);
}

inline MistakenTensor find(const model::Inertial& inertial, const mass::MassProperties& solid) {
  const model::Pose& X_LC = inertial.pose.pose.value;
  const mass::Inertia written = mass::tensor(inertial);  // along the axes of C
  const mass::Inertia tensor = mass::rotated(X_LC.rotation, written);
  const double off = difference(tensor, solid.about_com);
  if (!(off > kOff)) return {};
  MistakenTensor found;
  double least = std::min(kFits, off / kBetter);
  const auto try_one = [&](TensorMistake mistake, const mass::Inertia& undone) {
    const double now = difference(undone, solid.about_com);
    if (!(now < least)) return false;
    least = now;
    found.mistake = mistake;
    return true;
  };
  try_one(TensorMistake::kProductsNegated,
          mass::rotated(X_LC.rotation, with_products_negated(written)));
  try_one(TensorMistake::kAboutLinkOrigin,
          tensor - mass::point_inertia(solid.mass, X_LC.translation));
  try_one(TensorMistake::kTurned, written);
  if (found.mistake == TensorMistake::kTurned || has_products(written)) return found;
  constexpr std::array<std::array<std::size_t, 3>, 5> kOrders{
      {{1, 0, 2}, {0, 2, 1}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}};
  for (const auto& order : kOrders) {
    const mass::Inertia undone = mass::rotated(X_LC.rotation, permuted(written, order));
    if (try_one(TensorMistake::kAxesSwapped, undone)) found.belongs = order;
  }
  return found;
}

}  // namespace tensor_mistake

/// Judged by the collisions when these are all solids, else by the visuals.
inline MistakenTensor mistaken_tensor(const model::Link& link, Context& context) {
  const double mass = link.inertial.mass.value;
  if (!has_tensor(link, context) || !link.inertial.mass.written || !(mass > 0)) return {};
  if (!is_dynamic(link, context)) return {};
  if (!context.verdict(link).possible()) return {};
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto solid = solid_of_all(link, from, context);
    if (!solid || !(solid->mass > 0)) continue;
    if (mass > mass::kDensest * solid->mass) continue;  // a placeholder, not the body
    return tensor_mistake::find(link.inertial, mass::with_mass(*solid, mass));
  }
  return {};
}

}  // namespace rigor::rules
