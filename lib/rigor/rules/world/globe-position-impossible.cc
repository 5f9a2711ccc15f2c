// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::globe_position_impossible {

constexpr double kMaxLatitude = 90;  // degrees

// Some count east from 0 to 360.
constexpr double kMaxLongitude = 360;

void check(const model::World& world, Context& context) {
  if (!world.globe_position) return;
  const auto& [latitude, longitude] = *world.globe_position;
  if (std::abs(latitude.value) > kMaxLatitude) {
    const bool swapped = longitude.written && std::abs(longitude.value) <= kMaxLatitude &&
                         std::abs(latitude.value) <= kMaxLongitude;
    Finding finding{
        .where = latitude.span,
        .message = fmt::format("the latitude is {}°: the poles are at 90°", latitude.value),
        .subject = context.subject(world)};
    if (swapped)
      finding.fix = swap("swap latitude and longitude", latitude.span, longitude.span, context);
    context.report(std::move(finding));
  } else if (std::abs(longitude.value) > kMaxLongitude) {
    context.report(
        {.where = longitude.span,
         .message = fmt::format("the longitude is {}°: a turn has 360°", longitude.value),
         .subject = context.subject(world)});
  }
}

Rule rule() {
  return {
      .name = "globe-position-impossible",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a world's latitude or longitude is nowhere on the globe",
      .why = "<spherical_coordinates> places the origin of the world on the globe; satellite "
             "navigation and magnetometers use it. Beyond the pole, or round the globe more than "
             "once, they give places that no map has. Mostly latitude and longitude were swapped, "
             "or are not in degrees.",
      .what_to_do =
          "Write degrees north (at most 90) in latitude_deg and degrees east in longitude_deg.",
      .checks = {on<model::World>(check)},
  };
}

}  // namespace rigor::rules::globe_position_impossible
