// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/inertia/refused_inertia.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_not_finite {

void check(const model::Link& link, Context& context) {
  const model::Inertial& i = link.inertial;
  const std::pair<const char*, const model::Field<double>*> entries[] = {
      {"ixx", &i.ixx}, {"ixy", &i.ixy}, {"ixz", &i.ixz},
      {"iyy", &i.iyy}, {"iyz", &i.iyz}, {"izz", &i.izz}};
  // A tensor is broken once, however many of its entries are.
  const model::Field<double>* first = nullptr;
  std::string message;
  bool alone = true;
  for (const auto& [name, entry] : entries) {
    if (!entry->written || std::isfinite(entry->value)) continue;
    if (first == nullptr) {
      first = entry;
      message = fmt::format("{} is {}: it must be a finite number of kg·m²", name, entry->value);
    } else {
      message += (std::exchange(alone, false) ? ", and so must " : ", ") + std::string(name);
    }
  }
  if (first == nullptr) return;
  context.report({.where = first->span,
                  .message = std::move(message),
                  .subject = context.subject(link),
                  .refused = refuses_inertia(link, context)});
}

Rule rule() {
  return {
      .name = "inertia-not-finite",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "an entry of an inertia tensor is infinite or not a number",
      .why = "libsdformat rejects nan and lets inf pass. urdfdom drops the inertial with an error. "
             "No simulator can use the tensor.",
      .what_to_do = "Write the moment in kg·m². A link that must not turn is fixed to the world, "
                    "or made kinematic.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_not_finite
