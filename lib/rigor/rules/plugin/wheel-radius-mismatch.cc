// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::wheel_radius_mismatch {

// A tire is pressed in, and authors measure collision, visual or data sheet.
constexpr double kMaxOff = 0.12;

void check_against(const model::Parameter& parameter, double factor,
                   const std::vector<double>& radii, const model::Plugin& plugin,
                   Context& context) {
  const auto written = positive_number(parameter);
  if (!written || radii.empty()) return;
  const bool fits = std::any_of(radii.begin(), radii.end(), [&](double radius) {
    return std::abs(*written - factor * radius) < kMaxOff * factor * radius;
  });
  if (fits) return;
  const char* name = factor == 1 ? "radius" : "diameter";
  const Span where = trimmed(parameter, context);
  const std::string right = value_with_digits(*written, factor * radii.front());
  context.report(
      {.where = where,
       .message = fmt::format("the plugin's wheel {0} is {1:.6g} m, and the wheels have a "
                              "{0} of {2} m",
                              name, *written, right),
       .subject = context.subject(plugin),
       .help = fmt::format("write {}", right),
       .fix = Fix{"write that of the wheels", Applicability::kUnsafe, {{where, right}}}});
}

void check(const model::Plugin& plugin, Context& context) {
  const auto drive = drive_of(plugin, context);
  if (!drive) return;
  std::vector<double> radii = drive->left.front().radii;
  for (const auto* side : {&drive->left, &drive->right}) {
    for (const DrivenWheel& wheel : *side) {
      radii.insert(radii.end(), wheel.radii.begin(), wheel.radii.end());
    }
  }
  for (const auto* radius : drive->radii) check_against(*radius, 1, radii, plugin, context);
  for (const auto* diameter : drive->diameters) check_against(*diameter, 2, radii, plugin, context);
}

Rule rule() {
  return {
      .name = "wheel-radius-mismatch",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a drive plugin's wheel radius or diameter is not that of the wheels",
      .why = "The robot drives faster or slower than commanded, and its odometry is wrong by the "
             "same factor: by two where a diameter was written for a radius. The plugin turns the "
             "wheels by speed over radius, and looks at no geometry.",
      .what_to_do = "Write the radius, or the diameter where the parameter says so, in meters.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::wheel_radius_mismatch
