// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/refused_inertia.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_not_positive_definite {

std::string help(const mass::Inertia& tensor) {
  if (tensor.ixx < 0 || tensor.iyy < 0 || tensor.izz < 0)
    return "a moment is below zero: check its sign";
  return "an off-diagonal entry is too large for the moments beside it";
}

void check(const model::Link& link, Context& context) {
  if (!has_tensor(link, context)) return;
  const mass::Verdict& verdict = context.verdict(link);
  if (!verdict.tensor_finite || verdict.smallest != mass::Verdict::Sign::kNegative) return;
  const bool refused = refuses_inertia(link, context);
  if (!refused && is_rounding_of_zero(verdict)) return;  // inertia-singular
  const auto& moments = verdict.principal;
  context.report(
      {.where = link.inertial.tensor_site.name,
       .message = fmt::format("a principal moment of the tensor is negative ({:.4g} kg·m²; the "
                              "others are {:.4g} and {:.4g}): no body has this",
                              moments[0], moments[1], moments[2]),
       .subject = context.subject(link),
       .help = help(mass::tensor(link.inertial)),
       .fix = fix_from_shapes(link, context),
       .refused = refused});
}

Rule rule() {
  return {
      .name = "inertia-not-positive-definite",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "an inertia tensor is not positive definite",
      .why =
          "libsdformat (Gazebo) and MuJoCo reject the model, libsdformat without naming the number "
          "(error 18); Drake warns and takes a ball of water in its place. About some axis the body would turn against a push. urdfdom does not "
          "check it.",
      .what_to_do = "Compute the tensor again from the mass and the shapes. Mind the order ixx ixy "
                    "ixz iyy iyz izz and the units.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_not_positive_definite
