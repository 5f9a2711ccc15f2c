// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::products_of_inertia_negated {

std::string with_other_sign(std::string_view number) {
  if (number.starts_with('-')) return std::string(number.substr(1));
  if (number.starts_with('+')) number.remove_prefix(1);
  return "-" + std::string(number);
}

Fix negate(const model::Inertial& inertial, const Context& context) {
  Fix fix{"give the products the other sign", Applicability::kUnsafe, {}};
  for (const auto* product : {&inertial.ixy, &inertial.ixz, &inertial.iyz}) {
    if (!product->written || product->value == 0) continue;
    fix.edits.push_back({product->span, with_other_sign(context.bytes(product->span))});
  }
  return fix;
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (inertial.ixy.value == 0 && inertial.ixz.value == 0 && inertial.iyz.value == 0) return;
  if (mistaken_tensor(link, context).mistake != TensorMistake::kProductsNegated) return;
  context.report({.where = inertial.tensor_site.name,
                  .message = fmt::format(
                      "ixy, ixz and iyz ({:.4g}, {:.4g} and {:.4g} kg·m²) have the opposite sign "
                      "of what the link's shapes have; the rest of the tensor fits",
                      inertial.ixy.value, inertial.ixz.value, inertial.iyz.value),
                  .subject = context.subject(link),
                  .fix = negate(inertial, context)});
}

Rule rule() {
  return {
      .name = "products-of-inertia-negated",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the products of inertia have the opposite sign",
      .why = "The body has its principal axes mirrored, and moves differently from the real one. "
             "SDF and URDF want the entries of the tensor, ixy = -∫xy dm; some CAD programs and "
             "mesh tools print the products ∫xy dm. A link that was copied from the robot's other "
             "side has the same fault.",
      .what_to_do = "Give ixy, ixz and iyz the other sign.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::products_of_inertia_negated
