// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The fix that all rules about inertials share: what the link's shapes have as solids, written in
// place of what is there. `rigor inertia` writes the same numbers, but a center of mass that is
// written stays: no rule that has this fix doubts it. Where no body in the shapes can have it there
// is no fix, but for a center at the link's origin, which is often no more than a default.

#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <rigor/mass/proposal.h>
#include <rigor/read/values.h>
#include <rigor/rules/context.h>
#include <rigor/rules/geometry/suspicious_size.h>
#include <rigor/rules/inertia/outline.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/write/write_inertial.h>

namespace rigor::rules {

/// Lead has 11,340 kg/m³: shapes that would have more are not the whole body.
inline constexpr double kDensestOfParts = 12'000;  // kg/m³

/// Centres of mass that are nearer to each other are the same but for rounding.
inline constexpr double kSameCenter = 1e-9;  // m

/// What the fix does to the mass stands in its title: without a written one it changes.
inline std::string title_of(const mass::Proposal& proposal, const model::Inertial& written,
                            const Context& context) {
  const double density = proposal.body.mass / proposal.volume;
  if (proposal.mass_from == mass::MassFrom::kWritten) {
    return fmt::format("write the inertial of its shapes as solids, {:.4g} kg at {:.4g} kg/m³",
                       proposal.body.mass, density);
  }
  const double before = context.is_urdf() || written.mass.written ? 0 : 1;
  return fmt::format(
      "write the inertial of its shapes as solids of {:.4g} kg/m³{}: {:.4g} kg instead of {} kg",
      density, density > 999.9 && density < 1000.1 ? ", which is water" : "", proposal.body.mass,
      before);
}

/// Whether the sizes of the link's shapes are likely to be in another unit than meters.
inline bool has_suspicious_shape(const model::Link& link, const Context& context) {
  const auto any = [&context](const auto& parts) {
    return std::any_of(parts.begin(), parts.end(), [&context](auto id) {
      return suspicious_size(context.root()[id].geometry.shape).has_value();
    });
  };
  return any(link.collisions) || any(link.visuals);
}

/// Whether the mass or the moments are where no consumer reads them: in attributes in SDF, in elements in
/// URDF. Rules about the schema tell of that, and nothing is written over what the author knows.
inline bool has_unread_values(const model::Link& link, const Context& context) {
  if (!link.inertial.written) return false;
  const xml::Element inertial = context.element(link.inertial.site);
  const bool in_attributes = read::values_are_attributes(inertial);
  for (const std::string_view name : {"mass", "inertia"}) {
    const auto part = inertial.child(name);
    if (!in_attributes && inertial.attribute(name)) return true;
    if (!part) continue;
    if (!in_attributes && !part->attributes().empty()) return true;
    if (in_attributes && (!part->children().empty() || !read::trimmed(part->text()).empty()))
      return true;
  }
  return false;
}

/// Whether a value of the inertial stands there and is no number: what it was meant to be is not known.
inline bool has_malformed_value(const model::Inertial& inertial, const Context& context) {
  const auto malformed = [](const std::optional<read::Text>& text) {
    return text && !read::trimmed(text->text).empty() && !read::number_field(text, 0).written;
  };
  if (!inertial.written) return false;
  const xml::Element element = context.element(inertial.site);
  const bool in_attributes = read::values_are_attributes(element);
  if (const auto mass = element.child("mass")) {
    const read::Text text{mass->text(), mass->text_span()};
    if (malformed(in_attributes ? read::attribute_text(*mass, "value") : text)) return true;
  }
  const auto tensor = element.child("inertia");
  if (!tensor) return false;
  for (const std::string_view name : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
    if (malformed(read::child_text(*tensor, name))) return true;
  }
  return false;
}

/// Whether a body within the shapes can have its tensor about another center. Along an axis the mean square of the
/// distance from the center c is (c - a)(b - c) at most for what lies between a and b (R. Bhatia, C. Davis, "A better
/// bound on the variance", American Mathematical Monthly 107(4), 2000).
inline bool fits_about(const model::Vector3& center, const mass::MassProperties& body,
                       const Outline& shapes) {
  const mass::Inertia& tensor = body.about_com;
  const double half = mass::trace(tensor) / 2;  // Σ m r²
  const auto fits = [&](const model::Vector3& axis, double moment) {
    const double c = model::dot(axis, center);
    return half - moment <= body.mass * (c + shapes.reach(-1 * axis)) * (shapes.reach(axis) - c);
  };
  return fits({1, 0, 0}, tensor.ixx) && fits({0, 1, 0}, tensor.iyy) && fits({0, 0, 1}, tensor.izz);
}

/// Nothing when neither the collisions nor the visuals are all solids that can be the body, or when
/// the author's own numbers or sizes are in doubt.
inline std::optional<Fix> fix_from_shapes(const model::Link& link, Context& context) {
  if (has_suspicious_shape(link, context) || has_unread_size(link, context) ||
      has_unread_values(link, context) || has_malformed_value(link.inertial, context)) {
    return std::nullopt;
  }
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto proposal = mass::propose(link.inertial, context.body(link, from), {});
    if (!proposal) continue;
    if (proposal->body.mass > kDensestOfParts * proposal->volume) continue;
    if (proposal->body.mass < kAir * proposal->volume) continue;
    const auto format = context.is_urdf() ? write::BlockFormat::kUrdf : write::BlockFormat::kSdf;
    mass::MassProperties body = proposal->body;
    std::string title = title_of(*proposal, link.inertial, context);
    const model::Vector3& center = link.inertial.pose.pose.value.translation;
    if (link.inertial.pose.pose.written && length(center - body.com) > kSameCenter) {
      Outline shapes(link, context);
      const bool known =
          from == mass::From::kCollisions ? shapes.add_collisions(link) : shapes.add_visuals(link);
      const bool stays = known && fits_about(center, body, shapes);
      // Who wrote a center of mass knew it, and these are no part of what is wrong.
      if (!stays && length(center) > kSameCenter) continue;
      if (stays) body.com = center;
      title += stays ? ", about the written center of mass" : ", about their own center of mass";
    }
    auto edits =
        write::write_inertial(context.document(), context.element(link.site), body, format);
    if (edits.empty()) return std::nullopt;
    return Fix{std::move(title), Applicability::kUnsafe, std::move(edits)};
  }
  return std::nullopt;
}

}  // namespace rigor::rules
