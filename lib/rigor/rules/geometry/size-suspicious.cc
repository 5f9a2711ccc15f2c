// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/geometry/suspicious_size.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::size_suspicious {

// m: what a part of a robot measures, where the size was written in another unit.
constexpr double kLikelySmall = 0.01;
constexpr double kLikelyLarge = 5;

struct Unit {
  const char* name;
  double meter;
};
constexpr Unit kUnits[] = {{"millimeters", 0.001}, {"centimeters", 0.01}};

std::string meant(double size) {
  for (const Unit& unit : kUnits) {
    const double meters = size * unit.meter;
    if (meters < kLikelySmall || meters > kLikelyLarge) continue;
    return fmt::format("if the sizes are in {}, {:.3g} m are meant", unit.name, meters);
  }
  return {};
}

template <class Part>
void check(const Part& part, Context& context) {
  const auto largest = suspicious_size(part.geometry.shape);
  if (!largest) return;
  const model::Root& root = context.root();
  const model::Link& link = root[part.link];
  if (link.kinematic.value || !link.model || is_static(root, link.model)) return;
  context.report({.where = part.geometry.site.name,
                  .message = fmt::format("the {} is {:.4g} m large, and its link moves",
                                         model::shape_name(part.geometry.shape), *largest),
                  .subject = context.subject(part),
                  .help = meant(*largest)});
}

Rule rule() {
  return {
      .name = "size-suspicious",
      .severity = Severity::kWarning,
      .summary = "a shape of a link that moves is larger than 100 m",
      .why = "A part of 300 mm that was written as 300 is as large as a stadium: it throws all "
             "else about, and no camera sees its outside. Sizes are in meters.",
      .what_to_do = "Write the size in meters. Static models are not checked.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::size_suspicious
