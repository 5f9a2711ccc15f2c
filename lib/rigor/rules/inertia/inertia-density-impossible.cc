// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/mass/proposal.h>
#include <rigor/rules/inertia/moment_slips.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_density_impossible {

constexpr double kPi = 3.14159265358979323846;

// Tokens for frames that had to have some mass, and what may be one.
constexpr double kToken = 1e-5;       // kg
constexpr double kMaybeToken = 1e-2;  // kg
// A twelfth of air, and less than any frame of tubes.
constexpr double kVoid = 0.1;      // kg/m³
constexpr double kNothing = 1e-3;  // kg/m³

// Links of robots, hollow and with motors in them, judged by their moments.
constexpr double kLightLink = 100;   // kg/m³
constexpr double kHeavyLink = 9000;  // kg/m³

/// Of all bodies of one density the ball has the least moments: a part of the body is at least as dense
/// as the ball with these, kg/m³.
double least_density(double mass, double trace) {
  const double gyration2 = trace / 2 / mass;  // m²: Σ m r² / m is 3/5 R² of a ball
  return mass / (4 * kPi / 3 * std::pow(gyration2 * 5 / 3, 1.5));
}

struct Box {
  std::array<double, 3> sides{};  ///< m
  double density = 0;             ///< kg/m³
};

/// The solid box that has these principal moments. A rod and a sheet are dense, however far they reach.
Box box_of(double mass, const std::array<double, 3>& principal) {
  constexpr double kThin = 1e-3;  // m
  Box box{{}, mass};
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = principal[(k + 1) % 3] + principal[(k + 2) % 3] - principal[k];
    box.sides[k] = std::max(kThin, std::sqrt(std::max(0.0, 6 * along / mass)));
    box.density /= box.sides[k];
  }
  return box;
}

/// The one slip that, undone, makes it a body like those of robots.
const MomentSlip* slip_of(double mass, double trace) {
  const MomentSlip* found = nullptr;
  for (const MomentSlip& slip : kMomentSlips) {
    const double density = least_density(mass * slip.mass, trace * slip.moments);
    if (density < kLightLink || density > kHeavyLink) continue;
    if (found != nullptr) return nullptr;
    found = &slip;
  }
  return found;
}

/// Whether one digit is written for all three moments: somebody chose a number that lets the body turn slowly, as
/// in tests. What is a million times too large is a unit all the same.
bool is_made_up(const std::array<double, 3>& moments) {
  constexpr double kSame = 1e-9;
  const auto [low, high] = std::minmax({moments[0], moments[1], moments[2]});
  if (high - low > kSame * high) return false;
  const double digit = high / std::pow(10, std::floor(std::log10(high)));
  return std::abs(digit - std::round(digit)) < kSame;
}

/// What is wrong, and how bad it is; nothing where a material could be found.
struct Judgement {
  std::string message;
  Severity severity = Severity::kWarning;
};

std::optional<Judgement> judged(double mass, const mass::Verdict& verdict) {
  const auto& moments = verdict.principal;
  const double least = least_density(mass, moments[0] + moments[1] + moments[2]);
  if (least > mass::kDensest) {
    return Judgement{fmt::format("{} kg with moments of {:.3g}, {:.3g} and {:.3g} kg·m² have at "
                                 "least {:.3g} kg/m³; the densest metal has 22,590",
                                 mass, moments[0], moments[1], moments[2], least)};
  }
  const Box box = box_of(mass, moments);
  if (box.density > kVoid) return std::nullopt;
  const bool made_up = is_made_up(moments) && box.density > kNothing;
  return Judgement{fmt::format("{} kg with these moments are a solid of {:.3g} × {:.3g} × {:.3g} "
                               "m and {:.2g} kg/m³; air has 1.2",
                               mass, box.sides[0], box.sides[1], box.sides[2], box.density),
                   mass <= kMaybeToken || made_up ? Severity::kInfo : Severity::kWarning};
}

/// Whether the moments were computed of the link's own shapes: then the mass or the sizes are in doubt, which is
/// what density-too-low and density-too-high are about.
bool is_of_shapes(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  const mass::Inertia tensor =
      mass::rotated(inertial.pose.pose.value.rotation, mass::tensor(inertial));
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto solid = solid_of_all(link, from, context);
    if (!solid || !(solid->mass > 0)) continue;
    const mass::Inertia own = mass::with_mass(*solid, inertial.mass.value).about_com;
    if (tensor_mistake::difference(tensor, own) < tensor_mistake::kFits) return true;
  }
  return false;
}

void check(const model::Root& root, Context& context) {
  constexpr mass::Inertia kIdentity{1, 0, 0, 1, 0, 1};  // inertia-identity is about that
  for (const model::Link& link : root.links) {
    const model::Inertial& inertial = link.inertial;
    const double mass = inertial.mass.value;
    if (!root.own(link.site) || !inertial.mass.written || !(mass > kToken)) continue;
    if (!has_tensor(link, context) || !is_dynamic(link, context)) continue;
    const mass::Verdict& verdict = context.verdict(link);
    if (!verdict.possible() || !(verdict.principal[2] > 0)) continue;
    if (is_rounding_of_zero(verdict) || mass::tensor(inertial) == kIdentity) continue;
    auto found = judged(mass, verdict);
    if (!found || is_of_shapes(link, context)) continue;
    const MomentSlip* slip = slip_of(mass, mass::trace(mass::tensor(inertial)));
    context.report({.where = inertial.tensor_site.name,
                    .message = std::move(found->message),
                    .subject = context.subject(link),
                    .help = slip ? slip->help : "",
                    .fix = slip ? std::optional(undo(*slip, inertial)) : std::nullopt,
                    .severity = found->severity});
  }
}

Rule rule() {
  return {
      .name = "inertia-density-impossible",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "no material has the density that a link's mass and moments of inertia give",
      .why = "Joints of such a link accelerate without bound, or move as if in honey. Of all "
             "bodies of one density a ball has the smallest moments, so mass and moments alone "
             "say how dense a body is at least; and a solid box with these moments says how dense "
             "it is about. A thousandth in the moments is a factor of 30,000 in the density. "
             "Shapes are not needed; where the moments are just those of the link's own, "
             "density-too-low or density-too-high says it. What is lighter than air is an info up "
             "to a mass of 10 g, "
             "which may be a token, and where the same digit is written for all three moments, "
             "as tests have it.",
      .what_to_do = "Write the mass in kilograms and the moments in kg·m². `rigor inertia MODEL` "
                    "shows what the link's shapes have.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::inertia_density_impossible
