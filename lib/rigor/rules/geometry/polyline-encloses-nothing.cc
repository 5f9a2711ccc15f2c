// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <variant>

#include <fmt/core.h>

#include <rigor/mass/polyline.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::polyline_encloses_nothing {

// Whether its sides cross takes the square of their number: here some milliseconds. No author writes more
// by hand, and no program crosses its own lines.
constexpr std::size_t kMaxSides = 1000;

template <class Part>
void check(const Part& part, Context& context) {
  const auto* line = std::get_if<model::Polyline>(&part.geometry.shape);
  if (line == nullptr || line->points.size() > kMaxSides || line->height.value <= 0) return;
  const auto& points = line->points;
  // What cannot be read is reported by the schema's rules.
  if (!std::all_of(points.begin(), points.end(), [](const auto& p) { return p.written; })) return;
  std::string what;
  if (points.size() < 3) {
    what = fmt::format("has {} point{}: an outline takes three at least", points.size(),
                       points.size() == 1 ? "" : "s");
  } else if (!mass::solid_of(*line)) {
    what = "crosses or touches itself, or has no area";
  } else {
    return;
  }
  context.report({.where = part.geometry.site.name,
                  .message = "the polyline " + what,
                  .subject = context.subject(part)});
}

Rule rule() {
  return {
      .name = "polyline-encloses-nothing",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "the outline of a <polyline> has too few points, or crosses itself",
      .why = "Of fewer than three points, or where sides cross, none or wrong ones come out: the "
             "shape has holes, or is not there. Gazebo cuts the outline into triangles and "
             "extrudes them.",
      .what_to_do = "Write the corners one after another in the order in which they follow each "
                    "other round the outline. A hole is a second <polyline> in the same geometry.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::polyline_encloses_nothing
