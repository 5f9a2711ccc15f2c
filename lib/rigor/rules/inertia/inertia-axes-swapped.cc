// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_axes_swapped {

using Moments = std::array<const model::Field<double>*, 3>;

Fix put_where_they_belong(const Moments& moments, const std::array<std::size_t, 3>& belongs,
                          const Context& context) {
  Fix fix{"write each moment at its own axis", Applicability::kUnsafe, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (belongs[k] == k) continue;
    fix.edits.push_back({moments[belongs[k]]->span, std::string(context.bytes(moments[k]->span))});
  }
  return fix;
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (inertial.ixx.value == inertial.iyy.value && inertial.iyy.value == inertial.izz.value) return;
  const MistakenTensor found = mistaken_tensor(link, context);
  if (found.mistake != TensorMistake::kAxesSwapped) return;
  const Moments moments{&inertial.ixx, &inertial.iyy, &inertial.izz};
  std::array<double, 3> right{};
  for (std::size_t k = 0; k < 3; ++k) right[found.belongs[k]] = moments[k]->value;
  context.report(
      {.where = inertial.tensor_site.name,
       .message = fmt::format(
           "ixx, iyy and izz are {:.4g}, {:.4g} and {:.4g} kg·m², but fit the link's shapes only "
           "as {:.4g}, {:.4g} and {:.4g}: they are at the wrong axes",
           moments[0]->value, moments[1]->value, moments[2]->value, right[0], right[1], right[2]),
       .subject = context.subject(link),
       .fix = put_where_they_belong(moments, found.belongs, context)});
}

Rule rule() {
  return {
      .name = "inertia-axes-swapped",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "moments of inertia are swapped between axes",
      .why = "The link rotates about each axis with the moment of another one. Formulas for a "
             "cylinder or a box assume its length along one axis; when the shape is rotated, or "
             "the formula has other axes, the moments must be permuted.",
      .what_to_do = "Exchange the moments.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_axes_swapped
