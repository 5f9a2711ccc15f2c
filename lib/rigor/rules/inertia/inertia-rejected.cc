// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <vector>

#include <rigor/rules/inertia/refused_inertia.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_rejected {

/// Whether another rule finds something in what the link itself says.
bool is_reported_itself(const model::Link& link, const Context& context) {
  const model::Inertial& i = link.inertial;
  if (!i.written) return false;
  if (i.mass.written && !(i.mass.value >= 0 && std::isfinite(i.mass.value))) return true;
  const mass::Inertia t = mass::tensor(i);
  if (!std::isfinite(t.ixx + t.iyy + t.izz + t.ixy + t.ixz + t.iyz)) return true;
  if (!has_tensor(link, context)) return false;
  const mass::Verdict verdict = mass::judge(i.mass.value, t);
  return verdict.smallest == mass::Verdict::Sign::kNegative || !verdict.triangle.holds;
}

void report_refused(const model::Link& link, std::string_view why, Context& context) {
  context.report({.where = link.inertial.written ? link.inertial.site.name : link.site.name,
                  .message = "libsdformat rejects the inertia of this link" + std::string(why),
                  .subject = context.subject(link)});
}

void check(const model::Link& link, Context& context) {
  if (!context.is_sdf() || !link.inertial.written) return;
  if (!refuses_inertia(link, context) || is_reported_itself(link, context)) return;
  report_refused(link,
                 ": the moments miss the triangle inequality by a rounding, or together with the "
                 "entries that are not written",
                 context);
}

/// Of a URDF each link of the model is judged with what is lumped into it.
void check_robot(const model::Model& robot, Context& context) {
  if (!context.is_urdf()) return;
  const SdformatRobot& left = context.sdformat_robot();
  std::vector<bool> reported(left.parts.size(), false);
  for (std::size_t i = 0; i < left.parts.size(); ++i) {
    if (is_reported_itself(context.root()[robot.links[i]], context))
      reported[left.parts[i].head] = true;
  }
  for (std::size_t i = 0; i < left.parts.size(); ++i) {
    if (left.parts[i].head != i || reported[i] || !left.refuses_inertia(i)) continue;
    report_refused(context.root()[robot.links[i]], " together with those at its fixed joints",
                   context);
  }
}

Rule rule() {
  return {
      .name = "inertia-rejected",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .targets = {Target::kGazeboClassic, Target::kGzSim},
      .summary = "libsdformat rejects an inertia although each number could be right",
      .why = "libsdformat allows the triangle inequality no more than ten roundings of a double, "
             "so a plate whose moments are written with few digits is rejected (error 18). Where "
             "some entries are not written it takes 1 for the moments and 0 for the others.",
      .what_to_do =
          "Write all six entries, and as many digits as there are, or round the largest down.",
      .checks = {on<model::Link>(check), on<model::Model>(check_robot)},
  };
}

}  // namespace rigor::rules::inertia_rejected
