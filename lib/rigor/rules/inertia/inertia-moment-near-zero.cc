// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/outline.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_moment_near_zero {

// Of the other two, which are equal. A rod with such moments is thirty times as long as thick.
constexpr double kTooSmall = 3e-3;

/// How equal the two others are: a rod's are, but for what is mounted on it.
constexpr double kEqual = 0.1;

// What the shapes must have at least, times what is written, to make it a slip and not a rod.
constexpr double kOff = 20;

using Moments = std::array<const model::Field<double>*, 3>;

/// The moment that is near zero beside two equal ones; null when none is.
const model::Field<double>* near_zero(const model::Inertial& inertial) {
  Moments moments{&inertial.ixx, &inertial.iyy, &inertial.izz};
  std::sort(moments.begin(), moments.end(),
            [](const auto* a, const auto* b) { return a->value < b->value; });
  const double larger = moments[2]->value;
  if (!(moments[0]->value > 0) || !(moments[0]->value < kTooSmall * larger)) return nullptr;
  if (larger - moments[1]->value > kEqual * larger) return nullptr;
  return moments[0];
}

double same_of(const mass::Inertia& tensor, const model::Inertial& inertial,
               const model::Field<double>* moment) {
  if (moment == &inertial.ixx) return tensor.ixx;
  return moment == &inertial.iyy ? tensor.iyy : tensor.izz;
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!has_tensor(link, context) || !is_dynamic(link, context)) return;
  if (!(inertial.mass.value > 0) || !context.verdict(link).possible()) return;
  const model::Field<double>* moment = near_zero(inertial);
  if (moment == nullptr) return;
  auto solid = solid_of_all(link, mass::From::kCollisions, context);
  if (!solid) solid = solid_of_all(link, mass::From::kVisuals, context);
  if (!solid || !(solid->mass > 0)) return;
  const mass::Inertia along =
      mass::rotated(model::conjugate(inertial.pose.pose.value.rotation), solid->about_com);
  const double share = same_of(along, inertial, moment) / mass::trace(along);
  const double written = moment->value / mass::trace(mass::tensor(inertial));
  if (!(share > kOff * written)) return;
  // Where it is about what the shapes have, the other two are wrong: inertia-geometry-mismatch.
  const double expected = same_of(along, inertial, moment) * inertial.mass.value / solid->mass;
  if (!(expected > kOff * moment->value)) return;
  context.report({.where = moment->span,
                  .message = fmt::format("the moment {:.4g} kg·m² is near zero beside the other "
                                         "two: the link's shapes have {:.2g} times as much",
                                         moment->value, share / written),
                  .subject = context.subject(link),
                  .fix = fix_from_shapes(link, context),
                  .severity = Severity::kWarning});
}

Rule rule() {
  return {
      .name = "inertia-moment-near-zero",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a moment of inertia is near zero beside two equal ones",
      .why = "Only a long thin rod has such moments, and the link's shapes are none: mostly the "
             "exponent is wrong, or the value of another axis was written. Joints about this axis "
             "accelerate without bound, and simulations become unstable.",
      .what_to_do = "`rigor inertia MODEL` shows the moments of the link's shapes, and writes them "
                    "with --write.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_moment_near_zero
