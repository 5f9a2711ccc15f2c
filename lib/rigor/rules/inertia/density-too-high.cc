// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <rigor/mass/proposal.h>
#include <rigor/rules/inertia/bases.h>
#include <rigor/rules/inertia/outline.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::density_too_high {

// Less is a token for a frame that had to have some mass, and a shape to be seen by.
constexpr double kMin = 0.01;  // kg

/// Of the box around the shapes, in which there is room for more than the body, m³. A sheet is taken to be
/// a millimeter thick.
double volume_around(const Outline& outline) {
  constexpr double kThin = 1e-3;  // m
  double volume = 1;
  for (const model::Vector3& d : {model::Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    volume *= std::max(kThin, outline.extent(d));
  }
  return volume;
}

/// A small cube or ball that only marks where the link is, with the mass of what is not drawn.
bool is_marker(const Outline& outline) {
  constexpr double kLargest = 0.05;  // m
  const double x = outline.extent({1, 0, 0});
  return x <= kLargest && outline.extent({0, 1, 0}) == x && outline.extent({0, 0, 1}) == x;
}

void check_link(const model::Link& link, LazyGroups& groups, LazyBases& bases, Context& context) {
  const model::Inertial& inertial = link.inertial;
  const double mass = inertial.mass.value;
  if (!inertial.mass.written || !(mass > kMin) || !std::isfinite(mass)) return;
  if (mass::is_automatic(link) || !is_dynamic(link, context)) return;
  const auto breaks = [mass](const Outline& outline) {
    return mass > mass::kDensest * volume_around(outline);
  };
  const auto outline = outline_that_breaks(link, groups, context, breaks);
  if (!outline || bases.has(link)) return;
  const double density = mass / volume_around(*outline);
  context.report(
      {.where = inertial.mass.span,
       .message = fmt::format(
           "{} kg do not fit into the link's shapes, which are {:.3g} × {:.3g} × "
           "{:.3g} m: that would be {} kg/m³ at least, and the densest metal "
           "has 22,590",
           mass, outline->extent({1, 0, 0}), outline->extent({0, 1, 0}), outline->extent({0, 0, 1}),
           density < 1e7 ? fmt::format("{:.0f}", density) : fmt::format("{:.3g}", density)),
       .subject = context.subject(link),
       .help = "masses are in kilograms, sizes in meters",
       .severity = is_marker(*outline) ? Severity::kInfo : Severity::kWarning});
}

void check(const model::Root& root, Context& context) {
  LazyGroups groups(context);
  LazyBases bases(context);
  for (const model::Link& link : root.links) {
    if (root.own(link.site)) check_link(link, groups, bases, context);
  }
}

Rule rule() {
  return {
      .name = "density-too-high",
      .severity = Severity::kWarning,
      .summary = "mass exceeds the density of any material in the link's shapes",
      .why = "Contacts of such a link are hard to solve: it penetrates what it rests on. Either "
             "the mass is in grams, or the sizes or a mesh are in the wrong unit, or the shapes "
             "represent a much larger body. A cube or sphere of up to 5 cm is taken for a marker: "
             "that is an info.",
      .what_to_do = "Give the mass in kilograms and the shapes the size of the body, in meters.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::density_too_high
