// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/moment_slips.h>
#include <rigor/rules/inertia/outline.h>
#include <rigor/rules/inertia/slip.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/inertia/write_tensor.h>
#include <rigor/rules/inertia/written_digits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_exceeds_shapes {

// What is drawn may be a little smaller than what was weighed: no bolts, no cables.
constexpr double kDrawnSmaller = 1.1;
constexpr double kThin = 1e-3;    // m: stickers, sheets
constexpr double kMin = 1e-3;     // kg; less is a token for a frame that had to have some mass
constexpr double kAlong = 0.999;  // cosine: what is called an axis by its name

/// How far the mass is from its center along a principal axis, root mean square.
struct Spread {
  model::Vector3 axis_L;  ///< unit vector
  double least = 0;       ///< m, with the written digits rounded in the file's favor
  double spread = 0;      ///< m
};

using Spreads = std::array<Spread, 3>;

/// Half the sum of the moments is Σ m r²; what an axis does not share of it, it has along itself.
Spreads spreads(const model::Inertial& inertial, const mass::Inertia& tensor,
                const Context& context) {
  const double mass = inertial.mass.value;
  const mass::PrincipalAxes principal = mass::principal_axes(tensor);
  double rounding = 0;
  for (const auto* entry : {&inertial.ixx, &inertial.iyy, &inertial.izz}) {
    rounding += half_of_last_digit(context.bytes(entry->span)) / 2;
  }
  Spreads result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& moments = principal.moments;
    const double along = (moments[(k + 1) % 3] + moments[(k + 2) % 3] - moments[k]) / 2;
    result[k] = {model::rotate(inertial.pose.pose.value.rotation, principal.axes[k]),
                 std::sqrt(std::max(0.0, along - rounding) / mass),
                 std::sqrt(std::max(0.0, along) / mass)};
  }
  return result;
}

/// Without joints the moments have little effect, unless they are far off.
constexpr double kFree = 2;

double leniency(const model::Link& link, const Context& context) {
  return context.root()[link.model].joints.empty() ? kFree : 1;
}

/// A body between two planes has its mass farthest from the center when half of it is on each, m.
double allowed(double width) { return kDrawnSmaller * width / 2 + kThin; }

// A rod in place of a leg is thinner than the leg, whose mass is spread along it all the same.
constexpr double kRod = 0.2;      // of its length
constexpr double kSlender = 0.5;  // of the spread along it
constexpr double kThicker = 1.5;

const Spread* impossible(const Spreads& spreads, const Outline& outline, double leniency) {
  const Spread* worst = nullptr;
  double most = leniency, longest = 0, farthest = 0;
  for (const Spread& spread : spreads) {
    longest = std::max(longest, outline.extent(spread.axis_L));
    farthest = std::max(farthest, spread.spread);
  }
  for (const Spread& spread : spreads) {
    const double extent = outline.extent(spread.axis_L);
    const bool rod = extent < kRod * longest && spread.spread < kSlender * farthest;
    const double limit = allowed(extent) * (rod ? kThicker : 1);
    if (spread.least <= most * limit) continue;
    most = spread.least / limit;
    worst = &spread;
  }
  return worst;
}

std::string axis_name(const model::Vector3& axis) {
  if (std::abs(axis.x) > kAlong) return "x";
  if (std::abs(axis.y) > kAlong) return "y";
  if (std::abs(axis.z) > kAlong) return "z";
  return fmt::format("({:.2f} {:.2f} {:.2f})", axis.x, axis.y, axis.z);
}

struct Box {
  double volume = 0;  ///< m³
  double trace = 0;   ///< m²: sum of its moments as a solid, per kilogram
};

/// Around the shapes, along the axes of the link.
Box box_around(const Outline& outline) {
  const double x = outline.extent({1, 0, 0}), y = outline.extent({0, 1, 0}),
               z = outline.extent({0, 0, 1});
  return {x * y * z, (x * x + y * y + z * z) / 6};
}

/// Whether another rule says what is wrong with the tensor.
bool reported_elsewhere(const model::Link& link, const Box& box, Context& context) {
  constexpr mass::Inertia kIdentity{1, 0, 0, 1, 0, 1};
  const double mass = link.inertial.mass.value;
  const mass::Inertia tensor = mass::tensor(link.inertial);
  if (mass > mass::kDensest * box.volume) return true;  // a placeholder, not the body
  const auto share = share_of_solid(link, mass, tensor, context);
  if (share && (!plausible(*share))) return true;
  if (tensor == kIdentity) return mass > 10 && !share;
  return mistaken_tensor(link, context).mistake != TensorMistake::kNone;
}

/// Whether the written center of mass lies outside of the shapes: then they are not the body, as the thin
/// box along a leg that has a motor beside it. A center at the link's origin is often no more than a default.
bool is_centered_outside(const model::Inertial& inertial, const Outline& outline) {
  const model::Vector3& center = inertial.pose.pose.value.translation;
  if (!inertial.pose.pose.written || length(center) < kThin) return false;
  const std::array<model::Vector3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return std::any_of(axes.begin(), axes.end(), [&](const model::Vector3& axis) {
    const double at = model::dot(axis, center);
    return at > outline.reach(axis) + kThin || -at > outline.reach(-1 * axis) + kThin;
  });
}

/// The tensor about the center of mass, where the written one is about the link's origin and then fits.
std::optional<mass::Inertia> moved_to_center(const model::Inertial& inertial,
                                             const Outline& outline, double leniency,
                                             const Context& context) {
  if (length(inertial.pose.pose.value.translation) < kThin) return std::nullopt;
  const mass::Inertia about_com = without_mass_at_center(inertial);
  if (!mass::judge(inertial.mass.value, about_com).possible()) return std::nullopt;
  const Spreads then = spreads(inertial, about_com, context);
  if (impossible(then, outline, leniency)) return std::nullopt;
  return about_com;
}

/// Of moments that are `share` times those of the box as a solid.
std::optional<Fix> fix_of_share(const model::Link& link, double share, double density,
                                Context& context) {
  const MomentSlip* slip = slip_of_share(share, density);
  return slip ? undo(*slip, link.inertial) : fix_from_shapes(link, context);
}

void check_link(const model::Link& link, LazyGroups& groups, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.mass.written || !(inertial.mass.value > kMin)) return;
  if (!has_tensor(link, context) || !is_dynamic(link, context)) return;
  if (!context.verdict(link).possible()) return;
  const double most = leniency(link, context);
  // In all directions together: what is less than any width needs no closer look.
  const double gyration = std::sqrt(mass::trace(mass::tensor(inertial)) / 2 / inertial.mass.value);
  std::optional<Spreads> all;
  const auto breaks = [&](const Outline& outline) {
    if (gyration <= most * allowed(outline.least_width())) return false;
    if (!all) all = spreads(inertial, mass::tensor(inertial), context);
    return impossible(*all, outline, most) != nullptr;
  };
  const auto outline = outline_that_breaks(link, groups, context, breaks);
  if (!outline) return;
  const Box box = box_around(*outline);
  if (reported_elsewhere(link, box, context)) return;
  const Spread& worst = *impossible(*all, *outline, most);
  const double extent = outline->extent(worst.axis_L);
  const double share = mass::trace(mass::tensor(inertial)) / (inertial.mass.value * box.trace);
  Finding finding{
      .where = inertial.tensor_site.name,
      .message = fmt::format(
          "by its moments of inertia the mass lies {1:.3g} m from its center along {0} (root mean "
          "square), but the link's shapes are only {2:.3g} m long there, which allows {3:.3g} m",
          axis_name(worst.axis_L), worst.spread, extent, extent / 2),
      .subject = context.subject(link)};
  const double density = inertial.mass.value / box.volume;
  if (is_centered_outside(inertial, *outline) && !slip_of_share(share, density)) return;
  if (const auto about_com = moved_to_center(inertial, *outline, most, context)) {
    finding.help = fmt::format(
        "the tensor looks as if it were about the link's origin: without the {} kg at the center "
        "of mass, {:.3g} m away, it fits",
        inertial.mass.value, length(inertial.pose.pose.value.translation));
    finding.fix = write_tensor(inertial, *about_com);
  } else {
    finding.help = guess_slip(share);
    finding.fix = fix_of_share(link, share, density, context);
  }
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "inertia-exceeds-shapes",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "moments of inertia are larger than any body inside the link's shapes can have",
      .why = "Wherever the mass is inside the shapes, even half of it at each end, it has smaller "
             "moments than these: so they are another body's, in another unit, or made up. The "
             "link rotates more sluggishly than the real one, and controllers are tuned to that. "
             "Where "
             "the center of mass lies outside of the shapes these are not the body, and only a "
             "slip of units is reported.",
      .what_to_do = "`rigor inertia MODEL` shows what the mass has in the link's shapes, and "
                    "writes it with --write.",
      .checks = {on<model::Root>(check_own_links<check_link>)},
  };
}

}  // namespace rigor::rules::inertia_exceeds_shapes
