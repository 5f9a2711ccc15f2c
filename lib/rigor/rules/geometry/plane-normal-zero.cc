// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <variant>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plane_normal_zero {

template <class Part>
void check(const Part& part, Context& context) {
  const auto* plane = std::get_if<model::Plane>(&part.geometry.shape);
  if (plane == nullptr || !plane->normal.written || length(plane->normal.value) > 0) return;
  context.report(
      {.where = plane->normal.span,
       .message = "the normal of the plane is 0 0 0: it faces nowhere",
       .subject = context.subject(part),
       .fix = Fix{"let it face up", Applicability::kUnsafe, {{plane->normal.span, "0 0 1"}}}});
}

Rule rule() {
  return {
      .name = "plane-normal-zero",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the normal of a plane is zero",
      .why = "Normalized, zero becomes NaN or stays zero, and nothing rests on the plane. The "
             "normal defines which side is up.",
      .what_to_do = "Write the direction the plane faces; 0 0 1 for a floor.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::plane_normal_zero
