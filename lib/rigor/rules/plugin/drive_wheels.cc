// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/plugin/drive_wheels.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/mass/mesh/survey.h>
#include <rigor/rules/kinematics/leader.h>
#include <rigor/write/numbers.h>

namespace rigor::rules {
namespace {

using model::Vector3;

// An axis that is so near to one of a shape's is it.
constexpr double kAlongShape = 0.99;

/// Lower case without underscores: wheel_separation and wheelSeparation are one.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c != '_') plain += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return plain;
}

bool mentions(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

/// Of the sides of a box around something round.
std::optional<double> radius_across(double a, double b) {
  constexpr double kOutOfRound = 0.1;
  if (std::abs(a - b) > kOutOfRound * std::max(a, b)) return std::nullopt;
  return (a + b) / 4;
}

/// Of what is round about the axis: the radius; of a mesh half of its sides across.
std::optional<double> radius_about(const Vector3& axis_S, const model::Shape& shape,
                                   Context& context) {
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return ball->radius.value;
  if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) {
    if (std::abs(axis_S.z) > kAlongShape) return cylinder->radius.value;
  }
  if (const auto* mesh = std::get_if<model::Mesh>(&shape)) {
    const mass::MeshSurvey* survey = context.survey(*mesh);
    if (survey == nullptr || !survey->usable()) return std::nullopt;
    const Vector3 size = survey->bounds.max - survey->bounds.min;
    const Vector3& scale = mesh->scale.value;
    const double x = std::abs(size.x * scale.x), y = std::abs(size.y * scale.y),
                 z = std::abs(size.z * scale.z);
    if (std::abs(axis_S.x) > kAlongShape) return radius_across(y, z);
    if (std::abs(axis_S.y) > kAlongShape) return radius_across(x, z);
    if (std::abs(axis_S.z) > kAlongShape) return radius_across(x, y);
  }
  return std::nullopt;
}

/// How far it reaches along the axis, m; 0 of a ball, which stands on a point.
double width_about(const Vector3& axis_S, const model::Shape& shape, Context& context) {
  if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) return cylinder->length.value;
  const auto* mesh = std::get_if<model::Mesh>(&shape);
  const mass::MeshSurvey* survey = mesh != nullptr ? context.survey(*mesh) : nullptr;
  if (survey == nullptr) return 0;
  const Vector3 size = survey->bounds.max - survey->bounds.min;
  const Vector3& scale = mesh->scale.value;
  return std::abs(axis_S.x * size.x * scale.x) + std::abs(axis_S.y * size.y * scale.y) +
         std::abs(axis_S.z * size.z * scale.z);
}

template <class Part>
void add_radii(const std::vector<model::Id<Part>>& parts, DrivenWheel& wheel, Context& context) {
  std::vector<double> across;  // of cylinders that the joint does not turn about their axes
  for (const auto id : parts) {
    const auto X_WS = context.frames().pose(id);
    if (!X_WS) continue;
    const Vector3 axis_S = rotate(inverse(*X_WS).rotation, wheel.axis);
    const auto radius = radius_about(axis_S, context.root()[id].geometry.shape, context);
    if (radius && *radius > 0) {
      wheel.radii.push_back(*radius);
      const double width = width_about(axis_S, context.root()[id].geometry.shape, context);
      wheel.width = std::max(width, wheel.width.value_or(0));
    }
    const auto* cylinder = std::get_if<model::Cylinder>(&context.root()[id].geometry.shape);
    if (!radius && cylinder != nullptr && cylinder->radius.value > 0)
      across.push_back(cylinder->radius.value);
  }
  // Its axis is wrong, and not the wheel.
  if (!wheel.radii.empty()) return;
  wheel.across = !across.empty();
  wheel.radii = std::move(across);
}

std::optional<DrivenWheel> wheel_named(const model::Parameter& named, model::Id<model::Model> scope,
                                       Context& context) {
  auto wheel = wheel_of(joint_named(context.frames(), scope, named.value.value), context);
  if (wheel) wheel->named = &named;
  return wheel;
}

}  // namespace

std::optional<DrivenWheel> wheel_of(model::Id<model::Joint> joint, Context& context) {
  const model::Frames& frames = context.frames();
  if (!joint || degrees_of_freedom(context.root()[joint].type) != 1) return std::nullopt;
  const auto axis = frames.axis(joint, 0);
  const auto X_WJ = frames.pose(joint);
  const auto child = frames.ends(joint).child;
  if (!axis || !X_WJ || !child) return std::nullopt;
  DrivenWheel wheel{joint, nullptr, X_WJ->translation, X_WJ->translation, *axis, {}};
  const model::Link& link = context.root()[child];
  add_radii(link.collisions, wheel, context);
  add_radii(link.visuals, wheel, context);
  Vector3 sum;
  double count = 0;
  for (const auto collision : link.collisions) {
    if (const auto X_WC = frames.pose(collision)) {
      sum = sum + X_WC->translation;
      ++count;
    }
  }
  if (count > 0) wheel.center = (1 / count) * sum;
  return wheel;
}

std::optional<double> positive_number(const model::Parameter& parameter) {
  const auto number = write::number_in(parameter.value.value);
  return number && *number > 0 && std::isfinite(*number) ? number : std::nullopt;
}

std::string value_with_digits(double written, double actual) {
  constexpr double kNear = 0.01;
  for (const double factor : {2.0, 10.0, 100.0, 1000.0}) {
    for (const double meant : {written / factor, written * factor}) {
      if (std::abs(meant - actual) < kNear * actual)
        return write::joined({write::settled(meant, written, meant)});
    }
  }
  return fmt::format("{:.6g}", actual);
}

Span trimmed(const model::Parameter& parameter, const Context& context) {
  Span span = parameter.value.span;
  const std::string_view bytes = context.bytes(span);
  const std::size_t first = bytes.find_first_not_of(write::kSpace);
  if (first == bytes.npos) return span;
  span.end =
      span.begin + static_cast<decltype(span.end)>(bytes.find_last_not_of(write::kSpace)) + 1;
  span.begin += static_cast<decltype(span.begin)>(first);
  return span;
}

std::optional<Drive> drive_of(const model::Plugin& plugin, Context& context) {
  if (!plugin.model) return std::nullopt;
  Drive drive;
  for (const model::Parameter& given : plugin.parameters) {
    const std::string name = plain_name(given.name);
    const bool steering = mentions(name, "steering");
    if (name == "wheelseparation" || name == "trackseparation") drive.separations.push_back(&given);
    if (name == "wheelradius") drive.radii.push_back(&given);
    if (name == "wheeldiameter") drive.diameters.push_back(&given);
    const bool left = mentions(name, "left"), right = mentions(name, "right");
    if (left == right) continue;
    if (const auto wheel = wheel_named(given, plugin.model, context)) {
      auto& side = steering ? (left ? drive.left_steering : drive.right_steering)
                            : (left ? drive.left : drive.right);
      side.push_back(*wheel);
    }
  }
  if (drive.left.empty() || drive.right.empty()) return std::nullopt;
  return drive;
}

}  // namespace rigor::rules
