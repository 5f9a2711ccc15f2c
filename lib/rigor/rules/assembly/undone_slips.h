// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Slips in a translation, undone one at a time: a unit, a decimal point, a sign. Whoever finds a part in
// the wrong place tries each and looks whether the part is then where it belongs.
//
//   for (const Undone& change : undone_slips(pose.translation)) {
//     if (touches(moved_by(pose, X_WL, change.value))) return change;
//   }

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/model/model.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>

namespace rigor::rules {

struct Undone {
  model::Vector3 value;  ///< m, in the frame of what was written
  std::string slip;      ///< "written in millimeters"
};

inline constexpr std::array<double model::Vector3::*, 3> kCoordinates{
    &model::Vector3::x, &model::Vector3::y, &model::Vector3::z};

inline std::string_view coordinate_name(std::size_t k) {
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  return kNames[k];
}

inline std::string slip_name(double factor) {
  if (factor == 1000) return "written in millimeters";
  if (factor == 100) return "written in centimeters";
  return "its decimal point slipped";
}

/// Of one coordinate: "z is written in millimeters".
inline std::string slip_of_coordinate(std::size_t k, double factor) {
  if (factor == 10) return fmt::format("the decimal point of {} slipped", coordinate_name(k));
  return fmt::format("{} is {}", coordinate_name(k), slip_name(factor));
}

/// A number of the file with its decimal point moved: its digits are kept.
inline double with_digits_of_decimal(double product) {
  return write::number_in(fmt::format("{:.15g}", product)).value_or(product);
}
inline double divided(double value, double factor) {
  return with_digits_of_decimal(value / factor);
}

/// Those that make it shorter, simplest first: one coordinate, then all.
inline std::vector<Undone> undone_slips(const model::Vector3& written) {
  constexpr std::array<double, 3> kFactors{10, 100, 1000};
  std::vector<Undone> result;
  std::size_t used = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (written.*kCoordinates[k] == 0) continue;
    ++used;
    for (const double factor : kFactors) {
      Undone change{written, slip_of_coordinate(k, factor)};
      change.value.*kCoordinates[k] = divided(written.*kCoordinates[k], factor);
      result.push_back(std::move(change));
    }
  }
  for (const double factor : kFactors) {
    if (used < 2) break;
    result.push_back(
        {{divided(written.x, factor), divided(written.y, factor), divided(written.z, factor)},
         factor == 10 ? "the decimal points slipped" : "all of it is " + slip_name(factor)});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (written.*kCoordinates[k] == 0) continue;
    Undone change{written, fmt::format("the sign of {} was lost", coordinate_name(k))};
    change.value.*kCoordinates[k] = -1 * written.*kCoordinates[k];
    result.push_back(std::move(change));
  }
  return result;
}

/// How far what a pose places moves in W when the pose's translation becomes `value`; `X_WL` is the pose
/// in W of what it places.
inline model::Vector3 shift_of(const model::Pose& pose, const model::Pose& X_WL,
                               const model::Vector3& value) {
  const model::Vector3 d_L = rotate(conjugate(pose.rotation), value - pose.translation);
  return rotate(X_WL.rotation, d_L);
}

inline std::string written_as(const model::Vector3& v) { return write::joined({v.x, v.y, v.z}); }

/// The place of a pose's numbers in the file; of a URDF origin that of one attribute.
inline Span place_of(const model::PoseField& pose, const Context& context,
                     std::string_view attribute = "xyz") {
  if (pose.site.span.nowhere() || !context.root().own(pose.site)) return pose.pose.span;
  if (const auto written = context.element(pose.site).attribute(attribute))
    return written->value_span();
  return pose.pose.span;
}

/// Edits that write this translation; none where the numbers are not the file's own bytes.
inline std::optional<Fix> translation_fix(const model::PoseField& pose, const model::Vector3& value,
                                          const Context& context) {
  if (pose.site.span.nowhere() || !context.root().own(pose.site)) return std::nullopt;
  const xml::Element element = context.element(pose.site);
  const std::string title = "write " + written_as(value);
  if (element.attribute("xyz")) {
    return fix_of(
        title, Applicability::kUnsafe,
        write::set_numbers(context.document(), element, "xyz", {value.x, value.y, value.z}));
  }
  if (element.name() != "pose" || !element.text_verbatim()) return std::nullopt;
  auto numbers = write::numbers_in(element.text());
  if (!numbers || numbers->size() < 6) return std::nullopt;
  (*numbers)[0] = value.x;
  (*numbers)[1] = value.y;
  (*numbers)[2] = value.z;
  return fix_of(title, Applicability::kUnsafe,
                write::set_numbers(context.document(), element, *numbers));
}

}  // namespace rigor::rules
